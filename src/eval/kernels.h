// One loop per operation over a block of numbers, compiled for several instruction sets.
#pragma once

#include <cstddef>

#include "formula/graph.h"

namespace saddle {

/// Instruction sets that the loops exist for. All give the same bits on a processor that has fused
/// multiply-add, as all since 2013 do; one that lacks it may differ in the last bit.
enum class CpuLevel { Sse2, Avx2, Avx512 };

/// The best level that this processor has; the environment variable SADDLE_CPU (sse2, avx2, avx512)
/// forces another. Decided at the first call. Throws Error (Input) for a SADDLE_CPU that is no
/// level, or one that the processor does not have.
CpuLevel cpu_level();

/// The levels that this processor has, from the lowest.
std::size_t supported_level_count();

/// "sse2", "avx2", "avx512".
const char* level_name(CpuLevel level);

/// The copy of a loop for a level.
template <class Loop>
Loop of_level(CpuLevel level, Loop sse2, Loop avx2, Loop avx512) {
  return level == CpuLevel::Sse2 ? sse2 : level == CpuLevel::Avx2 ? avx2 : avx512;
}

/// A source of numbers for a loop: `varies`: data[0], data[1] ...; otherwise data[0] every time.
struct Operand {
  const double* data = nullptr;
  bool varies = false;
};

/// out[i] = op(in[0], in[1], in[2]) for i < count. `out` may be the data of an operand, and does
/// not overlap one otherwise.
using Kernel = void (*)(double* out, const Operand* in, std::size_t count);

/// sin[i] and cos[i] of in[i] for i < count: cheaper than one after the other. `sin` or `cos` may
/// be `in`; they do not overlap otherwise.
using SinCosKernel = void (*)(double* sin, double* cos, const double* in, std::size_t count);

/// The loops of a level.
struct Kernels {
  const Kernel* of_op;  ///< by operation; leaves have none
  SinCosKernel sin_cos;

  Kernel operator[](Op op) const { return of_op[static_cast<std::size_t>(op)]; }
};
const Kernels& kernels(CpuLevel level);

}  // namespace saddle
