// One loop per operation over a block of numbers.
#pragma once

#include <array>
#include <cstddef>

#include "formula/graph.h"

namespace saddle {

/// A source of numbers for a loop: `varies`: data[0], data[1] ...; otherwise data[0] every time.
struct Operand {
  const double* data = nullptr;
  bool varies = false;
};

/// out[i] = op(in...) for i < count. `out` may be one of the operands' data, not overlap it
/// otherwise. At least one operand varies.
using Kernel = void (*)(double* out, const std::array<Operand, 3>& in, std::size_t count);

/// The loop of an operation; leaves have none.
Kernel kernel(Op op);

}  // namespace saddle
