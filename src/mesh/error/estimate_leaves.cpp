// The error indicator of mesh/error/error_indicator.cpp for many leaves, and for which of them it
// holds: smooth ones, far from folded. This file is compiled once for each CPU level, with
// SADDLE_LEVEL naming the level's function; it may use nothing but plain arithmetic (see
// eval/kernel_loops.cpp).
#include <math.h>

#include "mesh/distance/chord_error.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/cell_diagonal.h"
#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// A chord's ends and its sample.
struct Chord {
  LoopVector a, b, sample;
  LoopVector n_a, n_b, n;
};

/// The error of a chord by its sample.
struct ChordError {
  double distance;
  double square_of_tangent;  ///< between the sample's normal and the mean of those at the ends
  double is_plain;           ///< at least 0: a small arc whose normals face the same way
};

static inline ChordError error_of(const Chord& chord, double seen, double turn_counts) {
  const LoopVector along = minus(chord.b, chord.a);
  const LoopVector off = minus(chord.sample, times(0.5, plus(chord.a, chord.b)));
  const double square = dot(along, along);
  const double square_off = dot(off, off);
  const double part = dot(off, along) / square;
  const double first = dot(chord.n_a, chord.n);
  const double last = dot(chord.n_b, chord.n);
  const double along_normal =
      largest_height({along, chord.n_a, chord.n_b, chord.n}, part, dot(off, chord.n));
  const LoopVector aside = minus(off, times(part, along));
  const double beside = sqrt(dot(aside, aside));
  const double is_small = kSmallArc * kSmallArc * square - square_off;
  return {choose(seen, beside, along_normal),
          choose(turn_counts, square_of_tangent(chord.n_a, chord.n_b, chord.n), 0.0),
          smaller_of(is_small, smaller_of(first, last))};
}

static inline Chord side(const LeafSamples& leaves, size_t k, size_t i) {
  const LeafVertices& a = leaves.corner[k];
  const LeafVertices& b = leaves.corner[(k + 1) % 4];
  return {position_at(a, i), position_at(b, i), position_at(leaves.side[k], i),
          normal_at(a, i),   normal_at(b, i),   normal_at(leaves.side[k], i)};
}

static inline double square_of_side(const LeafSamples& leaves, size_t k, size_t i) {
  const LoopVector along =
      minus(position_at(leaves.corner[(k + 1) % 4], i), position_at(leaves.corner[k], i));
  return dot(along, along);
}

static void estimate_side(const LeafSamples& leaves, size_t k, size_t count, LeafErrors& errors) {
  LeafNumbers& farthest = k % 2 == 0 ? errors.distance.along_u : errors.distance.along_v;
  LeafNumbers& largest =
      k % 2 == 0 ? errors.square_of_tangent.along_u : errors.square_of_tangent.along_v;
#pragma GCC ivdep  // errors overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const double is_long = square_of_side(leaves, k, i) - leaves.seen_turn[i] * leaves.seen_turn[i];
    const double turn_counts = smaller_of(is_long, errors.turn_counts_on_sides[i]);
    const ChordError error = error_of(side(leaves, k, i), leaves.seen[k][i], turn_counts);
    const double counts = leaves.counts[k][i];
    farthest[i] = larger_of(farthest[i], choose(counts, error.distance, 0.0));
    largest[i] = larger_of(largest[i], choose(counts, error.square_of_tangent, 0.0));
    errors.is_plain[i] = error.is_plain >= 0 ? errors.is_plain[i] : 0.0;
  }
}

/// The errors along the diagonal that the cell would be cut along, and above its triangles.
static void estimate_centre(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
  const LeafVertices* const side = leaves.side.data();
#pragma GCC ivdep  // errors overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector p0 = position_at(corner[0], i), p1 = position_at(corner[1], i);
    const LoopVector p2 = position_at(corner[2], i), p3 = position_at(corner[3], i);
    const LoopVector n0 = normal_at(corner[0], i), n1 = normal_at(corner[1], i);
    const LoopVector n2 = normal_at(corner[2], i), n3 = normal_at(corner[3], i);
    const LoopVector c = position_at(leaves.centre, i);
    const LoopVector n = normal_at(leaves.centre, i);
    const double second = is_smaller(sagitta(p1, n1, p3, n3), sagitta(p0, n0, p2, n2)) ? 1.0 : 0.0;
    const Chord diagonal = {choose(second, p1, p0), choose(second, p3, p2), c,
                            choose(second, n1, n0), choose(second, n3, n2), n};
    const ChordError error = error_of(diagonal, 0, errors.turn_counts_at_centre[i]);
    const double h0 = dot(minus(position_at(side[0], i), times(0.5, plus(p0, p1))), n);
    const double h1 = dot(minus(position_at(side[1], i), times(0.5, plus(p1, p2))), n);
    const double h2 = dot(minus(position_at(side[2], i), times(0.5, plus(p2, p3))), n);
    const double h3 = dot(minus(position_at(side[3], i), times(0.5, plus(p3, p0))), n);
    const double middle = dot(minus(c, times(0.5, plus(diagonal.a, diagonal.b))), n);
    const double one = bulge(choose(second, h1, h0), choose(second, h2, h1), middle);
    const double two = bulge(choose(second, h3, h2), choose(second, h0, h3), middle);
    double least = error.is_plain;
    for (size_t k = 0; k < 4; ++k) least = smaller_of(least, dot(normal_at(side[k], i), n));
    errors.gap_at_centre[i] = error.distance;
    errors.distance.centre[i] = larger_of(error.distance, larger_of(one, two));
    errors.square_of_tangent.centre[i] = error.square_of_tangent;
    errors.is_plain[i] = least >= 0 ? errors.is_plain[i] : 0.0;
  }
}

/// Sets errors to 0. Leaves with a sample without a normal or a position are not plain.
static void reset(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
  const LeafVertices* const side = leaves.side.data();
#pragma GCC ivdep  // errors overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector n = normal_at(leaves.centre, i);
    double least = dot(n, n);
    for (size_t k = 0; k < 4; ++k) {
      const LoopVector at_corner = normal_at(corner[k], i);
      const LoopVector on_side = normal_at(side[k], i);
      least = smaller_of(least, smaller_of(dot(at_corner, at_corner), dot(on_side, on_side)));
    }
    errors.distance.along_u[i] = errors.distance.along_v[i] = 0;
    errors.square_of_tangent.along_u[i] = errors.square_of_tangent.along_v[i] = 0;
    errors.is_plain[i] = least > 0.5 ? 1.0 : 0.0;
  }
}

/// Decides whether turns of normals count: they are not visible across a thin leaf. At the centre
/// they count in leaves thicker than `seen_turn`. On sides they also count in narrow leaves, whose
/// long sides run along them; the sides of other slivers run across.
static void decide_which_turns_count(const LeafSamples& leaves, size_t count, LeafErrors& errors) {
  const LeafVertices* const corner = leaves.corner.data();
#pragma GCC ivdep  // errors overlap no samples
  for (size_t i = 0; i < count; ++i) {
    const LoopVector area = cross(minus(position_at(corner[2], i), position_at(corner[0], i)),
                                  minus(position_at(corner[3], i), position_at(corner[1], i)));
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
  reset(leaves, count, errors);
  decide_which_turns_count(leaves, count, errors);
  for (size_t k = 0; k < 4; ++k) estimate_side(leaves, k, count, errors);
  estimate_centre(leaves, count, errors);
}

}  // namespace saddle
