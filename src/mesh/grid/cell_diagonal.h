// Which diagonal a cell is cut along, by arcs and lengths: for the loops that are compiled once for
// each CPU level, as mesh/grid/loop_vectors.h says, and for single cells.
#pragma once

#include <math.h>

#include "mesh/grid/loop_vectors.h"

namespace saddle {

/// The height of a surface's arc above the chord from a to b, from the normals at its ends, for a
/// parabolic arc: |(n_b - n_a) . (p_b - p_a)| / 8.
static inline double sagitta(LoopVector p_a, LoopVector n_a, LoopVector p_b, LoopVector n_b) {
  return 0.125 * fabs(dot(minus(n_b, n_a), minus(p_b, p_a)));
}

/// Sagittas, and squares of lengths, that differ by a smaller part of them are equal. The diagonals
/// of a cell of a surface of revolution have the same sagitta, and rounding must not choose.
inline constexpr double kTie = 1e-6;
static inline bool is_smaller(double a, double b) {
  return a < b * (1 - kTie);
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
