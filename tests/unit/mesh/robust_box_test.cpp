#include "mesh/features/robust_box.h"

#include <gtest/gtest.h>

#include <vector>

namespace saddle {
namespace {

TEST(Quantile, HasTheShareOfTheNumbersBelowIt) {
  std::vector<double> numbers;
  for (int i = 0; i < 100; ++i) numbers.push_back((37 * i) % 100);
  EXPECT_EQ(quantile(numbers, 0), 0);
  EXPECT_EQ(quantile(numbers, 0.05), 5);
  EXPECT_EQ(quantile(numbers, 0.95), 95);
  EXPECT_EQ(quantile(numbers, 1), 99);
}

TEST(Quantile, IsZeroOfNoNumbers) {
  std::vector<double> none;
  EXPECT_EQ(quantile(none, 0.5), 0);
}

TEST(RobustBox, KeepsToWhatMostPointsKeepTo) {
  std::vector<dvec3> points;
  for (int i = 0; i < 100; ++i) points.emplace_back(i, -i, 7);
  points[0].x = -1e300;
  points[99].x = 1e300;
  const Bounds box = robust_box(points);
  EXPECT_EQ(box.low, dvec3(5, -94, 7));
  EXPECT_EQ(box.high, dvec3(95, -4, 7));
}

TEST(RobustBox, LeavesOutMoreWhereItWouldBeTooLong) {
  std::vector<dvec3> points;
  for (int i = 0; i < 100; ++i) points.emplace_back(i, i, i);
  const Bounds box = robust_box(points, dvec3(1000, 70, 1));
  EXPECT_EQ(box.low.x, 5);
  EXPECT_EQ(box.high.x, 95);
  EXPECT_LE(box.size().y, 70);
  EXPECT_GE(box.size().y, 65);
  EXPECT_EQ(box.low.z, 25) << "half of the points stay";
  EXPECT_EQ(box.high.z, 75);
}

/// The heights of 1/(r^2 - 1/4) at even shares of the square -1:1 in both: an inner bowl, of a
/// fifth of the points, below -4, and what is around the pole above 4/7.
TEST(RobustBox, ShowsBothSidesOfAPoleWhereTheLargerAloneWouldFillIt) {
  std::vector<dvec3> points;
  for (int j = 0; j < 64; ++j) {
    for (int i = 0; i < 64; ++i) {
      const double u = (i + 0.5) / 32 - 1;
      const double v = (j + 0.5) / 32 - 1;
      points.emplace_back(u, v, 1 / (u * u + v * v - 0.25));
    }
  }
  const Bounds box = robust_box(points, dvec3(8));
  EXPECT_NEAR(box.size().z, 8, 1e-12);
  EXPECT_LT(box.low.z, -5);
  EXPECT_GT(box.high.z, 1.5);
}

TEST(RobustBox, IsInTheMiddleOfWhatIsSymmetric) {
  std::vector<dvec3> points;
  for (int i = -100; i < 100; ++i) points.emplace_back(0, 0, 100 / (i + 0.5));
  const Bounds box = robust_box(points, dvec3(10));
  EXPECT_EQ(box.low.z, -5);
  EXPECT_EQ(box.high.z, 5);
}

TEST(Bounds, ContainTheirFacesAndNothingBeyond) {
  Bounds box;
  box.add(dvec3(0));
  box.add(dvec3(1, 2, 3));
  EXPECT_TRUE(box.contains(dvec3(0, 2, 1.5)));
  EXPECT_FALSE(box.contains(dvec3(0, 2.1, 1.5)));
  EXPECT_FALSE(box.contains(dvec3(-0.1, 1, 1)));
  EXPECT_FALSE(Bounds().contains(dvec3(0)));
}

}  // namespace
}  // namespace saddle
