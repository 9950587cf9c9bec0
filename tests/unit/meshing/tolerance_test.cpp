// What is shown of surfaces that outgrow their pictures.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <vector>

#include "meshing/clip_box.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Finite points of a height field over [-reach, reach] x [-1, 1].
std::vector<dvec3> field(double reach, const std::function<double(double, double)>& z) {
  constexpr int kCells = 64;
  std::vector<dvec3> points;
  for (int i = 0; i < kCells; ++i) {
    for (int j = 0; j < kCells; ++j) {
      const double u = reach * (2 * (i + 0.37) / kCells - 1);
      const double v = 2 * (j + 0.59) / kCells - 1;
      const dvec3 p(u, v, z(u, v));
      if (std::isfinite(p.z)) points.push_back(p);
    }
  }
  return points;
}

double growth(double u, double) {
  return std::exp(u * u);
}

/// Of points that go as far as the surface does.
std::optional<Bounds> boxed(const std::vector<dvec3>& points) {
  Bounds all;
  for (const dvec3& p : points) all.add(p);
  return readable_box(all, points);
}

TEST(ReadableBox, HoldsThePartOfAGrowingSurfaceThatIsInProportion) {
  for (const double reach : {10.0, 30.0}) {  // up to 1e43, and beyond doubles
    const auto box = boxed(field(reach, growth));
    ASSERT_TRUE(box.has_value()) << reach;
    EXPECT_EQ(box->low.z, -std::numeric_limits<double>::infinity()) << "nothing is below";
    // exp(u*u) is four times as high as wide at u = 1.6; samples are up to a unit apart.
    EXPECT_GT(box->high.z, 8) << reach;
    EXPECT_LT(box->high.z, 25) << reach;
    EXPECT_FALSE(std::isfinite(box->low.x) || std::isfinite(box->high.x)) << reach;
    EXPECT_FALSE(std::isfinite(box->low.y) || std::isfinite(box->high.y)) << reach;
  }
}

TEST(ReadableBox, IsThereForNoSurfaceThatCanBeSeenAsItIs) {
  EXPECT_FALSE(boxed(field(2.5, growth)));  // 500 high
  EXPECT_FALSE(boxed(field(1, [](double, double) { return 0.0; })));
  EXPECT_FALSE(boxed({}));
}

TEST(ReadableBox, IsThereForNoSurfaceThatHasNoPartInProportion) {
  EXPECT_FALSE(boxed(field(1, [](double u, double v) { return 1e20 * (u + 0.3) * v; })));
  EXPECT_FALSE(boxed(field(1, [](double u, double) { return 1e6 * u; })));
}

TEST(ReadableBox, IsWhereMostOfTheSurfaceIs) {
  // Flat at 7 but for a wall on either side.
  const auto flat = [](double u, double) { return 7 + 1e9 * std::pow(u, 21); };
  const auto box = boxed(field(1, flat));
  ASSERT_TRUE(box.has_value());
  EXPECT_LT(box->low.z, 7);
  EXPECT_GT(box->high.z, 7);
  EXPECT_LT(box->high.z - box->low.z, 10);
}

/// tan(pi / 2) is 1.6e16 in double precision.
TEST(ReadableBox, LeavesOutAnEdgeThatGoesFarBeyondAllPoints) {
  const auto points = field(1, [](double u, double) { return std::tan(std::fabs(u) * kPi / 2); });
  Bounds all;
  for (const dvec3& p : points) all.add(p);
  EXPECT_FALSE(readable_box(all, points));
  all.high.z = std::tan(kPi / 2);
  auto box = readable_box(all, points);
  ASSERT_TRUE(box.has_value());
  EXPECT_GT(box->high.z, 2);
  EXPECT_LT(box->high.z, 50);
  box->high.z = 0;
  EXPECT_EQ(*box, (Bounds{dvec3(-kInfinity), dvec3(kInfinity, kInfinity, 0)}));
}

TEST(ReadableBox, IsWhereColumnsAreNearToEachOtherAndNotTheFullestOne) {
  // Each column of samples is a stretch of its own; one has more of them.
  auto points = field(1, [](double u, double v) { return 1e4 * u * u + v; });
  for (int k = 0; k < 150; ++k) points.emplace_back(0.7, 0.01 * k, 4900 + 0.01 * k);
  const auto box = boxed(points);
  ASSERT_TRUE(box.has_value());
  EXPECT_LT(box->low.z, 50);
  EXPECT_LT(box->high.z, 100);
}

}  // namespace
}  // namespace saddle
