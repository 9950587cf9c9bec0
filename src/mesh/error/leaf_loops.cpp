#include "mesh/error/leaf_loops.h"

namespace saddle {

// One copy of judge_leaves.cpp and of measure_leaves.cpp each.
void judge_leaves_sse2(const LeafSamples&, std::size_t, LeafVerdicts&);
void judge_leaves_avx2(const LeafSamples&, std::size_t, LeafVerdicts&);
void judge_leaves_avx512(const LeafSamples&, std::size_t, LeafVerdicts&);
void measure_leaves_sse2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafDeviations&);
void measure_leaves_avx2(const LeafPoints&, const LeafPlaces&, std::size_t, LeafDeviations&);
void measure_leaves_avx512(const LeafPoints&, const LeafPlaces&, std::size_t, LeafDeviations&);

JudgeLeaves judge_loop(CpuLevel level) {
  constexpr std::array kLevels = {judge_leaves_sse2, judge_leaves_avx2, judge_leaves_avx512};
  return kLevels[static_cast<std::size_t>(level)];
}

MeasureLeaves measure_loop(CpuLevel level) {
  constexpr std::array kLevels = {measure_leaves_sse2, measure_leaves_avx2, measure_leaves_avx512};
  return kLevels[static_cast<std::size_t>(level)];
}

}  // namespace saddle
