// Places without a proof.
#include "mesh/model/proof_gap.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

std::vector<ProofGap> merged(std::span<const ProofGap> places, const Domain& domain) {
  MergedGaps gaps(domain);
  for (const ProofGap& place : places) gaps.add(place);
  return gaps.take();
}

TEST(Doubts, OfOneReasonThatTouchAreOne) {
  const Domain domain{0, 1, 0, 1};
  const std::vector<ProofGap> places = {
      {GapReason::Boundary, {0.1, 0.1}, {0.2, 0.2}},
      {GapReason::Jump, {0.15, 0.1}, {0.2, 0.2}},
      {GapReason::Boundary, {0.2, 0.15}, {0.4, 0.2}},
      {GapReason::Boundary, {0.8, 0.8}, {0.8, 0.9}},
  };
  const std::vector<ProofGap> result = merged(places, domain);
  ASSERT_EQ(result.size(), 3U);
  EXPECT_EQ(result[0].why, GapReason::Boundary);
  EXPECT_EQ(result[0].low, dvec2(0.1, 0.1));
  EXPECT_EQ(result[0].high, dvec2(0.4, 0.2));
  EXPECT_EQ(result[1].low, dvec2(0.8, 0.8));
  EXPECT_EQ(result[2].why, GapReason::Jump);
  EXPECT_TRUE(merged({}, domain).empty());
}

TEST(Doubts, OfARangeThatRunsBackwardsContainWhatIsBetweenItsEnds) {
  const ProofGap place{GapReason::Pole, {1, 0}, {-1, 1}};
  EXPECT_TRUE(place.contains({0, 0.5}));
  EXPECT_FALSE(place.contains({0, 1.5}));
  const std::vector<ProofGap> result = merged(std::span(&place, 1), {1, -1, 0, 1});
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(result[0].low, dvec2(-1, 0));
  EXPECT_EQ(result[0].high, dvec2(1, 1));
}

}  // namespace
}  // namespace saddle
