// Judges many leaves as mesh/error/error_indicator.cpp does one, and tells of which that holds:
// they are smooth, and far from folded. This file is compiled once for each CPU level, with
// SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic (see
// eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/error/leaf_loops.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

constexpr double kNearlyOne = 1 - kTie;

static inline LoopVector position(const LeafVertices& of, size_t i) {
  return {of.x[i], of.y[i], of.z[i]};
}
static inline LoopVector normal(const LeafVertices& of, size_t i) {
  return {of.n_x[i], of.n_y[i], of.n_z[i]};
}
static inline double magnitude(double a) {
  return fabs(a);
}

/// A chord's ends and its sample.
struct Chord {
  LoopVector a, b, sample;
  LoopVector n_a, n_b, n;
};

/// What a chord's sample says: its distance, how far its normal is from between those of the ends
/// and, at least 0, that the arc is a small one whose normals face the same way.
struct Said {
  double distance;
  double square_of_tangent;
  double is_plain;
};

/// Height of the polynomial of Arc::largest_height() above the part s of the chord.
static inline double height_at(double s, double a, double b, double c) {
  return magnitude(s * (1 - s) * (a + s * (b + s * c)));
}

static inline Said test(const Chord& chord, double seen, double turn_counts) {
  const LoopVector along = minus(chord.b, chord.a);
  const LoopVector off = minus(chord.sample, times(0.5, plus(chord.a, chord.b)));
  const double square = dot(along, along);
  const double square_off = dot(off, off);
  const double part = dot(off, along) / square;
  const double height = dot(off, chord.n);
  const double first = dot(chord.n_a, chord.n);
  const double last = dot(chord.n_b, chord.n);
  // The polynomial s (1 - s) (a + b s + c s^2), s the share of the chord.
  const double share = 0.5 + part;
  const double weight = share * (1 - share);
  const double a = -dot(chord.n_a, along) / first;
  const double end = dot(chord.n_b, along) / last;
  const double middle = height / weight - a;
  const double c = ((end - a) * share - middle) / weight;
  const double b = end - a - c;
  const double outer = larger_of(height_at(0.25, a, b, c), height_at(0.75, a, b, c));
  const double inner = larger_of(height_at(0.375, a, b, c), height_at(0.625, a, b, c));
  const double bulge = larger_of(outer, inner);
  const double facing =
      smaller_of(smaller_of(first, last) - kSteepCosine, kAsideOfMiddle - magnitude(part));
  const double along_normal = larger_of(magnitude(height), choose(facing, bulge, 0.0));
  const LoopVector aside = minus(off, times(part, along));
  const double beside = sqrt(dot(aside, aside));
  const LoopVector sum = plus(chord.n_a, chord.n_b);
  const LoopVector sine = cross(sum, chord.n);
  const double cosine = dot(sum, chord.n);
  const double square_of_tangent = dot(sine, sine) / (cosine * cosine);
  const double is_small = kSmallArc * kSmallArc * square - square_off;
  return {choose(seen, beside, along_normal), choose(turn_counts, square_of_tangent, 0.0),
          smaller_of(is_small, smaller_of(first, last))};
}

static inline Chord side(const LeafSamples& leaves, size_t k, size_t i) {
  const LeafVertices& a = leaves.corner[k];
  const LeafVertices& b = leaves.corner[(k + 1) % 4];
  return {position(a, i), position(b, i), position(leaves.side[k], i),
          normal(a, i),   normal(b, i),   normal(leaves.side[k], i)};
}

static inline double square_of_side(const LeafSamples& leaves, size_t k, size_t i) {
  const LoopVector along =
      minus(position(leaves.corner[(k + 1) % 4], i), position(leaves.corner[k], i));
  return dot(along, along);
}

static void test_side(const LeafSamples& leaves, size_t k, size_t count, LeafErrors& errors) {
  LeafNumbers& farthest = k % 2 == 0 ? errors.distance.along_u : errors.distance.along_v;
  LeafNumbers& largest =
      k % 2 == 0 ? errors.square_of_tangent.along_u : errors.square_of_tangent.along_v;
#pragma GCC ivdep  // the verdicts overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const double is_long = square_of_side(leaves, k, i) - leaves.seen_turn[i] * leaves.seen_turn[i];
    const double turn_counts = smaller_of(is_long, errors.turn_counts_on_sides[i]);
    const Said said = test(side(leaves, k, i), leaves.seen[k][i], turn_counts);
    const double counts = leaves.counts[k][i];
    farthest[i] = larger_of(farthest[i], choose(counts, said.distance, 0.0));
    largest[i] = larger_of(largest[i], choose(counts, said.square_of_tangent, 0.0));
    errors.is_plain[i] = said.is_plain >= 0 ? errors.is_plain[i] : 0.0;
  }
}

/// bulge() of mesh/error/error_indicator.cpp.
static inline double bulge(double a, double b, double c) {
  const double x = magnitude(a);
  const double y = magnitude(b);
  const double z = magnitude(c);
  const double acute = smaller_of(smaller_of(y + z - x, z + x - y), x + y - z);
  const double area = 2 * (x * y + y * z + z * x) - x * x - y * y - z * z;  // squared
  const double same_side = smaller_of(a * b, b * c);
  const double inside = smaller_of(smaller_of(acute, area), same_side);
  return choose(inside, 4 * x * y * z / area, 0.0);
}

/// The diagonal along which the cell would be cut, and the largest height above its triangles.
static void test_middle(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
  const LeafVertices* const side = leaves.side.data();
#pragma GCC ivdep  // the verdicts overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector p0 = position(corner[0], i), p1 = position(corner[1], i);
    const LoopVector p2 = position(corner[2], i), p3 = position(corner[3], i);
    const LoopVector n0 = normal(corner[0], i), n1 = normal(corner[1], i);
    const LoopVector n2 = normal(corner[2], i), n3 = normal(corner[3], i);
    const LoopVector c = position(leaves.centre, i);
    const LoopVector n = normal(leaves.centre, i);
    const double first = magnitude(dot(minus(n2, n0), minus(p2, p0)));
    const double other = magnitude(dot(minus(n3, n1), minus(p3, p1)));
    const double second = other < first * kNearlyOne ? 1.0 : 0.0;
    const Chord diagonal = {choose(second, p1, p0), choose(second, p3, p2), c,
                            choose(second, n1, n0), choose(second, n3, n2), n};
    const Said said = test(diagonal, 0, errors.turn_counts_at_centre[i]);
    const double h0 = dot(minus(position(side[0], i), times(0.5, plus(p0, p1))), n);
    const double h1 = dot(minus(position(side[1], i), times(0.5, plus(p1, p2))), n);
    const double h2 = dot(minus(position(side[2], i), times(0.5, plus(p2, p3))), n);
    const double h3 = dot(minus(position(side[3], i), times(0.5, plus(p3, p0))), n);
    const double middle = dot(minus(c, times(0.5, plus(diagonal.a, diagonal.b))), n);
    const double one = bulge(choose(second, h1, h0), choose(second, h2, h1), middle);
    const double two = bulge(choose(second, h3, h2), choose(second, h0, h3), middle);
    double least = said.is_plain;
    for (size_t k = 0; k < 4; ++k) least = smaller_of(least, dot(normal(side[k], i), n));
    errors.gap_at_centre[i] = said.distance;
    errors.distance.centre[i] = larger_of(said.distance, larger_of(one, two));
    errors.square_of_tangent.centre[i] = said.square_of_tangent;
    errors.is_plain[i] = least >= 0 ? errors.is_plain[i] : 0.0;
  }
}

/// Samples without a normal, or without a position, are for others to judge.
static void begin(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
  const LeafVertices* const side = leaves.side.data();
#pragma GCC ivdep  // the verdicts overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector n = normal(leaves.centre, i);
    double least = dot(n, n);
    for (size_t k = 0; k < 4; ++k) {
      const LoopVector at_corner = normal(corner[k], i);
      const LoopVector on_side = normal(side[k], i);
      least = smaller_of(least, smaller_of(dot(at_corner, at_corner), dot(on_side, on_side)));
    }
    errors.distance.along_u[i] = errors.distance.along_v[i] = 0;
    errors.square_of_tangent.along_u[i] = errors.square_of_tangent.along_v[i] = 0;
    errors.is_plain[i] = least > 0.5 ? 1.0 : 0.0;
  }
}

/// Whether normals' turn counts: across a thin leaf it is not seen. The sides of one that is narrow
/// run along it, those of a sliver across.
static void look_at_turns(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
#pragma GCC ivdep  // the verdicts overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector area = cross(minus(position(corner[2], i), position(corner[0], i)),
                                  minus(position(corner[3], i), position(corner[1], i)));
    const double one = larger_of(square_of_side(leaves, 0, i), square_of_side(leaves, 2, i));
    const double other = larger_of(square_of_side(leaves, 1, i), square_of_side(leaves, 3, i));
    const double seen = leaves.seen_turn[i] * leaves.seen_turn[i];
    const double thick = dot(area, area) - 4 * seen * larger_of(one, other);
    errors.turn_counts_at_centre[i] = thick;
    errors.turn_counts_on_sides[i] = larger_of(thick, seen - smaller_of(one, other));
  }
}

}  // namespace

void SADDLE_LEVEL(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  begin(leaves, count, errors);
  look_at_turns(leaves, count, errors);
  for (size_t k = 0; k < 4; ++k) test_side(leaves, k, count, errors);
  test_middle(leaves, count, errors);
}

}  // namespace saddle
