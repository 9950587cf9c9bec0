// Which diagonal a cell is cut along, by arcs and lengths: for the loops that are compiled once for
// each CPU level, as mesh/grid/loop_vectors.h says, and for single cells.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"
#include "mesh/model/tolerances.h"

namespace saddle {

/// The height of a surface's arc above the chord from a to b, from the normals at its ends, for a
/// parabolic arc: |(n_b - n_a) . (p_b - p_a)| / 8.
static inline double sagitta(LoopVector p_a, LoopVector n_a, LoopVector p_b, LoopVector n_b) {
  return 0.125 * fabs(dot(minus(n_b, n_a), minus(p_b, p_a)));
}

/// Whether a is smaller than b by more than kNearly.
static inline bool is_smaller(double a, double b) {
  return a < b * (1 - kNearly);
}

/// The measures by which a diagonal is chosen.
struct Diagonal {
  double sagitta;
  double square;  ///< of the length
};

/// Whether `second` has the smaller sagitta; of equal ones, whether it is shorter.
static inline bool is_nearer(Diagonal second, Diagonal first) {
  const bool is_shorter = is_smaller(second.square, first.square);
  const bool unless_first = !is_smaller(first.sagitta, second.sagitta) && is_shorter;
  return is_smaller(second.sagitta, first.sagitta) || unless_first;
}

}  // namespace saddle
