// How far a triangle's point is from the surface at the same parameters: for the loops that are
// compiled once for each CPU level, as mesh/grid/loop_vectors.h says, and for single points.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {

/// Three vectors, one for each corner of a triangle.
struct LoopTriangle {
  LoopVector a, b, c;
};
static inline LoopTriangle choose(double condition, LoopTriangle yes, LoopTriangle no) {
  return {choose(condition, yes.a, no.a), choose(condition, yes.b, no.b),
          choose(condition, yes.c, no.c)};
}
static inline LoopVector mix(LoopTriangle t, LoopVector weights) {
  return plus(plus(times(weights.x, t.a), times(weights.y, t.b)), times(weights.z, t.c));
}

static inline double square_of_longest_side(LoopTriangle t) {
  const LoopVector ab = minus(t.b, t.a), bc = minus(t.c, t.b), ca = minus(t.a, t.c);
  return larger_of(larger_of(dot(ab, ab), dot(bc, bc)), dot(ca, ca));
}

/// The distance of the triangle's point with these weights from the surface, which is at `p` at the
/// same parameters: along its unit normal, since along the surface is no distance. 0 where the two
/// are too far apart for that.
static inline double height_above(LoopTriangle t, LoopVector weights, LoopVector p,
                                  LoopVector normal) {
  const LoopVector off = minus(mix(t, weights), p);
  const double height = fabs(dot(off, normal));
  const double longest = square_of_longest_side(t);
  const double aside = dot(off, off) - height * height;
  const double flat = kMostAbove * kMostAbove * longest - height * height;
  const double beside = kMostAside * kMostAside * longest - aside;
  return smaller_of(flat, beside) >= 0 ? height : 0.0;
}

/// The square of the difference between an exact unit normal and an interpolated one, made a unit
/// vector. `square`: the square of the latter's length.
static inline double square_of_chord(LoopVector interpolated, double square, LoopVector exact) {
  const LoopVector chord = minus(times(1 / ::sqrt(square), interpolated), exact);
  return dot(chord, chord);
}

}  // namespace saddle
