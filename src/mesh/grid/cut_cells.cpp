// Cuts all cells between two rows of vertices along the better diagonal, and finds the plain ones;
// triangulate.cpp cuts single cells. This file is compiled once for each CPU level, with
// SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic (see
// eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/grid/cell_diagonal.h"
#include "mesh/grid/cell_loops.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// The product of each of a plain cell's four normals with their sum exceeds 2. Two pairs of equal
/// normals are then less than a right angle apart; a surface that folds in the cell turns by more.
constexpr double kAgreement = 2;

/// Both triangles of a plain cell's best cut face as the sum of its normals does, by more than the
/// rounding of positions. Twice the area along the sum of the four normals, at most 4 long, exceeds
/// this times the largest coordinate and the root of the sum of squares of four edges; no other
/// edge is longer than twice that root. The factor is 2 * 2 * 2 * 4 * sqrt(3) times kRounding,
/// rounded up. Needles thinner than a rounding fail it too.
constexpr double kPlainArea = 64 * kRounding;

}  // namespace

void SADDLE_LEVEL(const Strip& lower, const Strip& upper, size_t cells, double front, Cuts& cuts) {
  const double size = larger_of(lower.size, upper.size);
  const double least = kPlainArea * kPlainArea * size * size;
#pragma GCC ivdep  // the cuts overlap no strip
  for (size_t i = 0; i < cells; ++i) {
    const LoopVector p0 = position_at(lower, i), p1 = position_at(lower, i + 1);
    const LoopVector p3 = position_at(upper, i), p2 = position_at(upper, i + 1);
    const LoopVector n0 = normal_at(lower, i), n1 = normal_at(lower, i + 1);
    const LoopVector n3 = normal_at(upper, i), n2 = normal_at(upper, i + 1);

    const LoopVector first = minus(p2, p0);  // the diagonals
    const LoopVector other = minus(p3, p1);
    const double sagitta_first = sagitta(p0, n0, p2, n2);
    const double sagitta_other = sagitta(p1, n1, p3, n3);
    const double square_first = dot(first, first);
    const double square_other = dot(other, other);
    const double second =
        is_nearer({sagitta_other, square_other}, {sagitta_first, square_first}) ? 1.0 : 0.0;

    // Twice the vector area of the cell, and of one of its triangles: at slot 1, or at slot 0.
    const LoopVector along_u = minus(p1, p0);
    const LoopVector along_v = minus(p3, p0);
    const LoopVector sum = plus(plus(n0, n1), plus(n2, n3));
    const double whole = front * dot(cross(first, other), sum);
    const double part = front * dot(cross(along_u, choose(second, along_v, first)), sum);
    const double rest = whole - part;
    const double area = smaller_of(rest, part);
    const double edges =
        square_first + square_other + dot(along_u, along_u) + dot(along_v, along_v);
    const double sides = larger_of(sagitta(p0, n0, p1, n1), sagitta(p0, n0, p3, n3));
    cuts.second[i] = second;
    const double agreement =
        smaller_of(smaller_of(dot(n0, sum), dot(n1, sum)), smaller_of(dot(n2, sum), dot(n3, sum)));
    const double facing = smaller_of(area, agreement - kAgreement);
    cuts.margin[i] = facing > 0 ? area * area - least * edges : -1.0;
    cuts.sagitta[i] = larger_of(sides, second > 0 ? sagitta_other : sagitta_first);
  }
}

}  // namespace saddle
