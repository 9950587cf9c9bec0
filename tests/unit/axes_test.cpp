#include "view/axes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace saddle {
namespace {

TEST(Ticks, AreRoundNumbersWithinTheRange) {
  EXPECT_EQ(ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
  EXPECT_EQ(ticks(-1, 1, 5), (std::vector<double>{-1, -0.5, 0, 0.5, 1}));
  EXPECT_EQ(ticks(100, 104, 5), (std::vector<double>{100, 101, 102, 103, 104}));
}

TEST(Ticks, AreNoneOfARangeWithoutLength) {
  EXPECT_TRUE(ticks(2, 2, 5).empty());
  EXPECT_TRUE(ticks(0, std::numeric_limits<double>::infinity(), 5).empty());
}

TEST(Axes, HaveTwelveEdgesTicksAndNames) {
  Bounds box;
  box.add(dvec3(-1));
  box.add(dvec3(1));
  Mesh marks;
  const std::vector<AxisLabel> labels = append_axes(box, marks);
  EXPECT_EQ(marks.lines.size(), 12U + 3 * 5);
  for (const char* name : {"x", "y", "z"}) {
    EXPECT_EQ(std::ranges::count(labels, name, &AxisLabel::text), 1) << name;
  }
  EXPECT_EQ(std::ranges::count(labels, "0.5", &AxisLabel::text), 3);
}

}  // namespace
}  // namespace saddle
