// Vectors whose components are columns of numbers: made unit, and laid one after the other, in
// loops compiled for each CPU level.
#pragma once

#include "eval/kernels.h"

namespace saddle {

/// The loops of a level, each for i < count. All levels write the same bits. Columns come as three
/// Operands or pointers, one for each component: vector i is that of the three numbers at i.
struct VectorLoops {
  /// to[3 i + k] = component k of vector i.
  void (*interleave)(const Operand* vectors, std::size_t count, double* to);

  /// The vectors divided by their lengths, and the lengths; units[k] may be the data of
  /// component k. A vector of length 0 becomes NaN. `sign`, 1 or -1, multiplies the unit vectors.
  void (*normalize)(const Operand* vectors, std::size_t count, double sign, double* const* units,
                    double* lengths);

  /// Positions as they are and `normals` made unit, both interleaved and rounded to float: in one
  /// loop, where shuffles and memory work while the slow root and division do.
  void (*floats)(const Operand* positions, const Operand* normals, std::size_t count,
                 float* position, float* normal);
};
const VectorLoops& vector_loops(CpuLevel level);

}  // namespace saddle
