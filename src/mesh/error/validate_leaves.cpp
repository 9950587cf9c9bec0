// The errors of leaves of two triangles at validation points, as sampled_error() of
// mesh/distance/sampled_error.cpp has them for one point. This file is compiled once for each CPU
// level, with SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic
// (see eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/distance/newton_step.h"
#include "mesh/distance/triangle_error.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// Squares of lengths from whose products no digit is lost to the ends of the range of doubles.
constexpr double kLargest = 1e+100;

static inline LoopVector vector_at(const LeafPlaces& places, size_t column, size_t i) {
  return {places.surface[column][i], places.surface[column + 1][i], places.surface[column + 2][i]};
}

/// The foot of a point on a triangle's plane.
struct Foot {
  double square;  ///< of the distance
  double height;  ///< on the side from which the corners are counter-clockwise
  LoopVector weights;
  double inside;  ///< the least weight
};
static inline Foot foot_on(const LoopTriangle& t, LoopVector p) {
  const LoopVector normal = cross(minus(t.b, t.a), minus(t.c, t.a));
  const double square = dot(normal, normal);
  const LoopVector from_a = minus(t.a, p), from_b = minus(t.b, p), from_c = minus(t.c, p);
  const double a = dot(cross(from_b, from_c), normal) / square;
  const double b = dot(cross(from_c, from_a), normal) / square;
  const LoopVector weights = {a, b, 1 - a - b};
  const double height = dot(from_a, normal);
  return {height * height / square, -height / sqrt(square), weights,
          smaller_of(smaller_of(a, b), weights.z)};
}

}  // namespace

void SADDLE_LEVEL(const LeafPoints& leaves, const LeafPlaces& places, size_t count,
                  LeafSampledErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
#pragma GCC ivdep  // errors overlap no input
  for (size_t i = 0; i < count; ++i) {
    const LoopVector p0 = position_at(corner[0], i), p1 = position_at(corner[1], i);
    const LoopVector p2 = position_at(corner[2], i), p3 = position_at(corner[3], i);
    const LoopVector n0 = normal_at(corner[0], i), n1 = normal_at(corner[1], i);
    const LoopVector n2 = normal_at(corner[2], i), n3 = normal_at(corner[3], i);
    const double p = places.p[i];
    const double q = places.q[i];
    const LoopVector point = times(leaves.scale, vector_at(places, 0, i));
    const LoopVector r_u = vector_at(places, 3, i);
    const LoopVector r_v = vector_at(places, 6, i);
    const LoopVector area = times(leaves.front, cross(r_u, r_v));
    const double square_area = dot(area, area);
    const double squares = dot(r_u, r_u) * dot(r_v, r_v);
    const LoopVector exact = times(1 / sqrt(square_area), area);

    // The triangle that (p, q) is in, and the other one.
    const double lower = p - q;
    const LoopTriangle first = {p0, p1, p2};
    const LoopTriangle second = {p2, p3, p0};
    const LoopTriangle own = choose(lower, first, second);
    const Foot on_own = foot_on(own, point);
    const LoopTriangle other = choose(lower, second, first);
    const Foot on_other = foot_on(other, point);
    const LoopVector in_first = {1 - p, p - q, q};
    const LoopVector in_second = {p, q - p, 1 - q};
    const double height = height_above(own, choose(lower, in_first, in_second), point, exact);

    const double is_on_own = on_own.inside >= 0 ? 1.0 : 0.0;
    const double on_first = lower > 0 ? is_on_own : 1 - is_on_own;
    const LoopVector weights = choose(is_on_own, on_own.weights, on_other.weights);
    const LoopTriangle normals =
        choose(on_first, LoopTriangle{n0, n1, n2}, LoopTriangle{n2, n3, n0});
    const LoopVector interpolated = mix(normals, weights);
    const double square_normal = dot(interpolated, interpolated);
    const double chord = square_of_chord(interpolated, square_normal, exact);
    const double distance = sqrt(choose(is_on_own, on_own.square, on_other.square));
    errors.distance[i] = larger_of(errors.distance[i], larger_of(distance, height));
    // The prediction, above the triangle that the point is straight above.
    const LoopTriangle above = choose(is_on_own, own, other);
    const LoopVector ab = minus(above.b, above.a), ac = minus(above.c, above.a);
    const double up = choose(is_on_own, on_own.height, on_other.height);
    const StepShape shape =
        step_shape(ab, ac, minus(normals.b, normals.a), minus(normals.c, normals.a), exact);
    const NewtonStep step =
        newton_step_from(shape, dot(exact, cross(ab, ac)) > 0 ? up : -up, weights.y, weights.z);
    errors.predicted[i] = larger_of(errors.predicted[i], step.height);
    errors.chord[i] = larger_of(errors.chord[i], chord);

    const double regular = smaller_of(
        smaller_of(square_area - kDegenerateCrossSquare * squares, squares - 1 / kLargest),
        kLargest - squares);
    const double inside = larger_of(on_own.inside, on_other.inside);
    const double is_known = inside >= 0 ? errors.is_known[i] : 0.0;
    const double is_regular = regular > 0 ? is_known : 0.0;
    errors.is_known[i] = square_normal > 0 ? is_regular : 0.0;
  }
}

}  // namespace saddle
