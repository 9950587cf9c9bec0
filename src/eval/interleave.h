// Columns of numbers into arrays of vectors, in loops compiled for each CPU level.
#pragma once

#include "eval/kernels.h"

namespace saddle {

/// to[3 i + k] = component k at i, for i < count.
template <class Real>
using Interleave = void (*)(const Operand& x, const Operand& y, const Operand& z, std::size_t count,
                            Real* to);

struct InterleaveLoops {
  Interleave<double> doubles;
  Interleave<float> floats;  ///< rounded
};

/// The loops of a level; all write the same bits.
const InterleaveLoops& interleave_loops(CpuLevel level);

}  // namespace saddle
