#include "eval/vectors.h"

namespace saddle {

// One copy of vector_loops.cpp each.
const VectorLoops& vectors_sse2();
const VectorLoops& vectors_avx2();
const VectorLoops& vectors_avx512();

const VectorLoops& vector_loops(CpuLevel level) {
  return of_level(level, vectors_sse2, vectors_avx2, vectors_avx512)();
}

}  // namespace saddle
