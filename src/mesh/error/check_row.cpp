// The errors of the triangles of a row of cells, at one place of the surface in each cell;
// check_cells.cpp has the scalar code for single places. This file is compiled once for each CPU
// level, with SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic
// (see eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/distance/triangle_error.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// A triangle's point counts as straight above the surface's if it is at most this part of the
/// triangle's shorter side aside. Curvature then changes the distance by at most a twentieth.
constexpr double kMostAsideInRow = 0.1;

struct Vertex {
  LoopVector position, normal;
};
static inline Vertex vertex(const Strip& strip, size_t i) {
  return {position_at(strip, i), normal_at(strip, i)};
}
static inline Vertex choose(double condition, const Vertex& yes, const Vertex& no) {
  return {choose(condition, yes.position, no.position), choose(condition, yes.normal, no.normal)};
}

}  // namespace

void SADDLE_LEVEL(const Strip& lower, const Strip& upper, const RowPlaces& places, size_t count,
                  RowErrors& errors) {
  const double* const* const column = places.surface.data();
#pragma GCC ivdep  // errors overlap no input
  for (size_t i = 0; i < count; ++i) {
    const Vertex v0 = vertex(lower, i), v1 = vertex(lower, i + 1);
    const Vertex v3 = vertex(upper, i), v2 = vertex(upper, i + 1);
    // The corners from the diagonal's first end on, and the place from there.
    const double second = places.second[i];
    const Vertex a = choose(second, v1, v0), b = choose(second, v2, v1);
    const Vertex c = choose(second, v3, v2), d = choose(second, v0, v3);
    const double p = choose(second, places.along_v, places.along_u[i]);
    const double q = choose(second, 1 - places.along_u[i], places.along_v);
    // The triangle that the place is in: a b c or c d a.
    const double is_first = p - q;
    const Vertex first = choose(is_first, a, c), next = choose(is_first, b, d);
    const Vertex last = choose(is_first, c, a);
    const LoopVector weights = {choose(is_first, 1 - p, p), fabs(p - q),
                                choose(is_first, q, 1 - q)};

    const LoopVector point =
        times(places.scale, LoopVector{column[0][i], column[1][i], column[2][i]});
    const LoopVector normal =
        times(places.front, LoopVector{column[3][i], column[4][i], column[5][i]});
    const LoopVector off =
        minus(mix({first.position, next.position, last.position}, weights), point);
    const double height = dot(off, normal);
    const double beside = dot(off, off) - height * height;
    const LoopVector along = minus(next.position, first.position);
    const LoopVector across = minus(last.position, first.position);
    const double square = smaller_of(dot(along, along), dot(across, across));
    const LoopVector mean = mix({first.normal, next.normal, last.normal}, weights);
    const double square_mean = dot(mean, mean);
    errors.distance[i] = fabs(height);
    errors.chord[i] = square_of_chord(mean, square_mean, normal);

    const double area = column[8][i];
    const double squares = column[6][i] * column[7][i];
    const double is_straight =
        beside <= kMostAsideInRow * kMostAsideInRow * square ? 1.0 : 0.0;  // not NaN
    const double is_regular = area * area > kDegenerateCrossSquare * squares ? is_straight : 0.0;
    const double has_normal = square_mean > 0 ? is_regular : 0.0;
    errors.is_known[i] = second >= 0 ? has_normal : 0.0;
  }
}

}  // namespace saddle
