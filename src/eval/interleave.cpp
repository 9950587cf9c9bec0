#include "eval/interleave.h"

namespace saddle {

// One copy of interleave_loops.cpp each.
const InterleaveLoops& interleave_sse2();
const InterleaveLoops& interleave_avx2();
const InterleaveLoops& interleave_avx512();

const InterleaveLoops& interleave_loops(CpuLevel level) {
  switch (level) {
    case CpuLevel::Sse2:
      return interleave_sse2();
    case CpuLevel::Avx2:
      return interleave_avx2();
    case CpuLevel::Avx512:
      return interleave_avx512();
  }
  return interleave_sse2();
}

}  // namespace saddle
