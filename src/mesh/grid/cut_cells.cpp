// Cuts all cells between two rows of vertices along the better diagonal, as triangulate.cpp does
// one by one, and tells which of them are plain. This file is compiled once for each CPU level,
// with SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic (see
// eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/grid/cell_loops.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// The four normals of a plain cell agree: each one's product with their sum is more than this. If
/// two are the same and the other two are the same, they are less than a right angle apart; a
/// surface that folds inside the cell turns by more.
constexpr double kAgreement = 2;

/// Both triangles of a plain cell's best cut face as the sum of its normals does, by more than the
/// rounding of positions could pretend: twice the area along the sum of the four normals, at most
/// 4 long, must exceed this times the largest coordinate and the root of the sum of squares of four
/// edges, of which no other edge is longer than twice. That is 2 * 2 * 2 * 4 * sqrt(3) times
/// kRounding, rounded up. Needles thinner than a rounding fail it too.
constexpr double kPlainArea = 64 * kRounding;

constexpr double kNearlyOne = 1 - kTie;

static inline LoopVector position(const Strip& strip, size_t i) {
  return {strip.x[i], strip.y[i], strip.z[i]};
}
static inline LoopVector normal(const Strip& strip, size_t i) {
  return {strip.n_x[i], strip.n_y[i], strip.n_z[i]};
}

}  // namespace

void SADDLE_LEVEL(const Strip& lower, const Strip& upper, size_t cells, double front, Cuts& cuts) {
  const double size = larger_of(lower.size, upper.size);
  const double least = kPlainArea * kPlainArea * size * size;
#pragma GCC ivdep  // the cuts overlap no strip
  for (size_t i = 0; i < cells; ++i) {
    const LoopVector p0 = position(lower, i), p1 = position(lower, i + 1);
    const LoopVector p3 = position(upper, i), p2 = position(upper, i + 1);
    const LoopVector n0 = normal(lower, i), n1 = normal(lower, i + 1);
    const LoopVector n3 = normal(upper, i), n2 = normal(upper, i + 1);

    const LoopVector first = minus(p2, p0);  // the diagonals
    const LoopVector other = minus(p3, p1);
    const double sagitta_first = fabs(dot(minus(n2, n0), first));
    const double sagitta_other = fabs(dot(minus(n3, n1), other));
    const double square_first = dot(first, first);
    const double square_other = dot(other, other);
    const double by_length = square_other < square_first * kNearlyOne ? 1.0 : 0.0;
    const double unless_first = sagitta_first < sagitta_other * kNearlyOne ? 0.0 : by_length;
    const double second = sagitta_other < sagitta_first * kNearlyOne ? 1.0 : unless_first;

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
    const double sides =
        larger_of(fabs(dot(minus(n1, n0), along_u)), fabs(dot(minus(n3, n0), along_v)));
    cuts.second[i] = second;
    const double agreement =
        smaller_of(smaller_of(dot(n0, sum), dot(n1, sum)), smaller_of(dot(n2, sum), dot(n3, sum)));
    const double facing = smaller_of(area, agreement - kAgreement);
    cuts.margin[i] = facing > 0 ? area * area - least * edges : -1.0;
    cuts.sagitta[i] = 0.125 * larger_of(sides, second > 0 ? sagitta_other : sagitta_first);
  }
}

}  // namespace saddle
