#include "mesh/error/error_loops.h"

namespace saddle {

// A copy of estimate_leaves.cpp and validate_leaves.cpp each.
void estimate_leaves_sse2(const LeafSamples&, std::size_t, LeafErrors&);
void estimate_leaves_avx2(const LeafSamples&, std::size_t, LeafErrors&);
void estimate_leaves_avx512(const LeafSamples&, std::size_t, LeafErrors&);
void validate_leaves_sse2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);
void validate_leaves_avx2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);
void validate_leaves_avx512(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);

EstimateLeaves estimate_loop(CpuLevel level) {
  return of_level(level, estimate_leaves_sse2, estimate_leaves_avx2, estimate_leaves_avx512);
}

ValidateLeaves validate_loop(CpuLevel level) {
  return of_level(level, validate_leaves_sse2, validate_leaves_avx2, validate_leaves_avx512);
}

}  // namespace saddle
