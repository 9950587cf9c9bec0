// Places of leaves.
#include "mesh/tree/leaf.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(Leaf, HasAMiddleInsideUnlessItIsOneUnitWide) {
  Leaf leaf{{kCellUnit, 3 * kCellUnit}};
  for (; leaf.size_v() > 1; ++leaf.halved_v) {
    EXPECT_TRUE(leaf.has_middle());
    EXPECT_GT(leaf.middle().v, leaf.low.v);
    EXPECT_LT(leaf.middle().v, leaf.high().v);
  }
  EXPECT_FALSE(leaf.has_middle());
  EXPECT_EQ(leaf.middle().v, leaf.low.v);
}

}  // namespace
}  // namespace saddle
