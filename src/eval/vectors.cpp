#include "eval/vectors.h"

#include <array>

namespace saddle {

// One copy of vector_loops.cpp each.
const VectorLoops& vectors_sse2();
const VectorLoops& vectors_avx2();
const VectorLoops& vectors_avx512();

const VectorLoops& vector_loops(CpuLevel level) {
  constexpr std::array kLevels = {vectors_sse2, vectors_avx2, vectors_avx512};
  return kLevels[static_cast<std::size_t>(level)]();
}

}  // namespace saddle
