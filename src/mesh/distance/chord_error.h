// Error estimates from a chord and the sample above it: for the loops that are compiled once for
// each CPU level, as mesh/grid/loop_vectors.h says, and for single leaves.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {

/// A chord of the surface, from a to b, and its unit normals at both ends and at the sample.
struct ChordNormals {
  LoopVector along;  ///< b - a
  LoopVector at_a, at_b, at_sample;
};

/// Height at the part s of a chord of the polynomial s (1 - s) (a + b s + c s^2).
static inline double height_at(double s, double a, double b, double c) {
  return fabs(s * (1 - s) * (a + s * (b + s * c)));
}

/// The largest height of an arc along its sample's normal. The arc is taken for the polynomial of
/// fourth order with the slopes at its ends and `height` at the part 0.5 + `from_middle` of the
/// chord: the middle of an arc with a turning point tells little. |height| of an arc that is too
/// steep for a polynomial, or whose sample is not about the middle.
static inline double largest_height(ChordNormals chord, double from_middle, double height) {
  const double first = dot(chord.at_a, chord.at_sample);
  const double last = dot(chord.at_b, chord.at_sample);
  const double share = 0.5 + from_middle;
  const double weight = share * (1 - share);
  const double a = -dot(chord.at_a, chord.along) / first;
  const double end = dot(chord.at_b, chord.along) / last;  // a + b + c
  const double middle = height / weight - a;               // b s + c s^2
  const double c = ((end - a) * share - middle) / weight;
  const double b = end - a - c;
  const double outer = larger_of(height_at(0.25, a, b, c), height_at(0.75, a, b, c));
  const double inner = larger_of(height_at(0.375, a, b, c), height_at(0.625, a, b, c));
  const double is_gentle =
      smaller_of(smaller_of(first, last) - kSteepCosine, kAsideOfMiddle - fabs(from_middle));
  return larger_of(fabs(height), choose(is_gentle, larger_of(outer, inner), 0.0));
}

/// The square of the tangent of the angle between two lines, along a sample's normal and along the
/// mean of those at the ends of its chord.
static inline double square_of_tangent(LoopVector at_a, LoopVector at_b, LoopVector at_sample) {
  const LoopVector sum = plus(at_a, at_b);
  const LoopVector sine = cross(sum, at_sample);
  const double cosine = dot(sum, at_sample);
  return dot(sine, sine) / (cosine * cosine);
}

/// The largest height of a quadratic function above a triangle, from those at the middles of its
/// sides: where it curves to one side, at the centre of the circle through the corners in the
/// metric of the curvature. 0 if that is outside: one of the sides has the largest height.
static inline double bulge(double a, double b, double c) {
  const double x = fabs(a);
  const double y = fabs(b);
  const double z = fabs(c);
  const double acute = smaller_of(smaller_of(y + z - x, z + x - y), x + y - z);
  const double area = 2 * (x * y + y * z + z * x) - x * x - y * y - z * z;  // squared
  const double same_side = smaller_of(a * b, b * c);
  const double inside = smaller_of(smaller_of(acute, area), same_side);
  return choose(inside, 4 * x * y * z / area, 0.0);
}

}  // namespace saddle
