#include "eval/vectors.h"

namespace saddle {

// One copy of vector_loops.cpp each.
const VectorLoops& vectors_sse2();
const VectorLoops& vectors_avx2();
const VectorLoops& vectors_avx512();

const VectorLoops& vector_loops(CpuLevel level) {
  switch (level) {
    case CpuLevel::Sse2:
      return vectors_sse2();
    case CpuLevel::Avx2:
      return vectors_avx2();
    case CpuLevel::Avx512:
      return vectors_avx512();
  }
  return vectors_sse2();
}

}  // namespace saddle
