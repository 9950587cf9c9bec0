#include "mesh/error/error_loops.h"

namespace saddle {

// A copy of estimate_leaves.cpp, validate_leaves.cpp and check_row.cpp each.
void estimate_leaves_sse2(const LeafSamples&, std::size_t, LeafErrors&);
void estimate_leaves_avx2(const LeafSamples&, std::size_t, LeafErrors&);
void estimate_leaves_avx512(const LeafSamples&, std::size_t, LeafErrors&);
void validate_leaves_sse2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);
void validate_leaves_avx2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);
void validate_leaves_avx512(const LeafPoints&, const LeafPlaces&, std::size_t, LeafSampledErrors&);
void check_row_sse2(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);
void check_row_avx2(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);
void check_row_avx512(const Strip&, const Strip&, const RowPlaces&, std::size_t, RowErrors&);

EstimateLeaves estimate_loop(CpuLevel level) {
  return of_level(level, estimate_leaves_sse2, estimate_leaves_avx2, estimate_leaves_avx512);
}

ValidateLeaves validate_loop(CpuLevel level) {
  return of_level(level, validate_leaves_sse2, validate_leaves_avx2, validate_leaves_avx512);
}

CheckRow check_loop(CpuLevel level) {
  return of_level(level, check_row_sse2, check_row_avx2, check_row_avx512);
}

}  // namespace saddle
