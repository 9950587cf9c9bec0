#include "mesh/distance/sheet_view.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(PredictedDistance, IsTheTopOfAnArc) {
  // 4 s (1 - s) at three shares.
  const auto arc = [](double share) { return Height{share, 4 * share * (1 - share)}; };
  EXPECT_NEAR(predicted_distance({arc(0.25), arc(0.45), arc(0.75)}), 1, 1e-12);
}

TEST(PredictedDistance, IsNoMultipleOfThoseMeasuredNextToAnEnd) {
  // A distance of 4e-5 at a share of 2e-7: the edge begins beside the chord.
  EXPECT_LT(predicted_distance({{{2.3e-7, 4e-5}, {0.504, 3.9e-5}, {0.667, 2.6e-5}}}), 1e-4);
  EXPECT_LT(predicted_distance({{{0.333, 2.6e-5}, {0.496, 3.9e-5}, {1 - 2.3e-7, 4e-5}}}), 1e-4);
}

TEST(HeightOfRoof, IsThatOfTheCornerBetweenTwoEdges) {
  EXPECT_NEAR(height_of_roof({0.25, 0.5}, {0.75, 0.5}), 1, 1e-12);
  EXPECT_NEAR(height_of_roof({0.2, 0.5}, {0.8, 0.25}), 1 / (0.4 + 0.8), 1e-12);
}

TEST(HeightOfRoof, IsNoMultipleOfOneMeasuredNextToAnEnd) {
  EXPECT_EQ(height_of_roof({2.3e-7, 4e-5}, {0.504, 4e-5}), 0);
  EXPECT_EQ(height_of_roof({0.504, 4e-5}, {1 - 2.3e-7, 4e-5}), 0);
}

}  // namespace
}  // namespace saddle
