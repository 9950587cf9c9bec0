#include "eval/point_count.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(PointCount, IsUsedUpByPointsAndByOtherWork) {
  PointCount count;
  count.add(1000);
  count.add_work(1000);
  EXPECT_FALSE(count.is_used_up()) << "nothing limits it yet";
  count.allow(10);
  count.add(4);
  count.add_work(5);
  EXPECT_FALSE(count.is_used_up());
  count.add_work(1);
  EXPECT_TRUE(count.is_used_up());
  EXPECT_EQ(count.total(), 1004U) << "work computes no points";
}

}  // namespace
}  // namespace saddle
