#include "export/figures/visible_lines.h"

#include <gtest/gtest.h>

#include <array>

namespace saddle {
namespace {

constexpr double kSide = 200;
/// What figures promise of the ends of hidden parts, in pixels.
constexpr double kPromised = 0.1;

/// Looks along -z at the square from -1 to 1, which fills the picture.
FittedCamera from_above(bool ortho) {
  Camera camera;
  camera.view = dvec3(0, 0, 1);
  camera.up = dvec3(0, 1, 0);
  camera.target = Vector(dvec3(0));
  camera.distance = Number(4);
  camera.fov = 2 * std::atan(0.25) * 180 / 3.14159265358979;
  camera.ortho = ortho;
  return fit_camera(camera, {dvec3(-1), dvec3(1)}, 1);
}

/// Hides what is behind x from `low` to `high`, at height z.
void add_strip(PictureDepths& depths, double low, double high, double z) {
  const dvec3 a(low, -1, z);
  const dvec3 b(high, -1, z);
  const dvec3 c(high, 1, z);
  const dvec3 d(low, 1, z);
  depths.add({a, b, c});
  depths.add({a, c, d});
}

double pixel(double x) {
  return (1 + x) / 2 * kSide;
}

TEST(VisibleLines, EndWhereWhatHidesThemBegins) {
  for (const bool ortho : {false, true}) {
    PictureDepths depths(from_above(ortho), {kSide, kSide});
    add_strip(depths, -0.3123, 0.4567, 0);
    const double deeper = ortho ? 1 : 1.125;  // as far out in the picture as at the target
    const std::array line = {dvec3(-0.9 * deeper, 0.1, -0.5), dvec3(0.9 * deeper, 0.1, -0.5)};
    const auto parts = depths.visible(line, 0);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_NEAR(parts[0].front().x, pixel(-0.9), 1e-6);
    EXPECT_NEAR(parts[0].back().x, pixel(-0.3123), kPromised);
    EXPECT_NEAR(parts[1].front().x, pixel(0.4567), kPromised);
    EXPECT_NEAR(parts[1].back().x, pixel(0.9), 1e-6);
  }
}

TEST(VisibleLines, AreWholeInFrontOfASurfaceAndOnIt) {
  PictureDepths depths(from_above(false), {kSide, kSide});
  add_strip(depths, -0.5, 0.5, 0);
  for (const double z : {0.0, 0.3}) {
    const auto parts = depths.visible(std::array{dvec3(-0.6, 0, z), dvec3(0.6, 0, z)}, 0);
    EXPECT_EQ(parts.size(), 1U) << z;
  }
}

TEST(VisibleLines, OutsideOfThePictureAreLeftOut) {
  PictureDepths depths(from_above(true), {kSide, kSide});
  const auto parts = depths.visible(std::array{dvec3(-3, 0, 0), dvec3(3, 0, 0)}, 0);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].front().x, 0, kPromised);
  EXPECT_NEAR(parts[0].back().x, kSide, kPromised);
}

/// A thin triangle, across many of the squares by which triangles are found, hides along all of its
/// length and nowhere else, whichever way it leans.
TEST(VisibleLines, EndBehindASliverWhereverItIs) {
  for (const double lean : {-0.9, -0.3, 0.0, 0.4, 0.8}) {
    PictureDepths depths(from_above(true), {kSide, kSide});
    const double width = 0.05;
    depths.add({dvec3(-lean, -0.95, 0), dvec3(width - lean, -0.95, 0), dvec3(lean, 0.95, 0)});
    for (int k = -45; k <= 45; ++k) {
      const double y = 0.02 * k;
      const double way = (y + 0.95) / 1.9;
      const double from = -lean + way * 2 * lean;
      const double to = from + (1 - way) * width;
      const auto parts = depths.visible(std::array{dvec3(-0.99, y, -0.5), dvec3(0.99, y, -0.5)}, 0);
      if (to - from < 0.011) continue;  // as wide as a pixel, which no line is sure to find
      ASSERT_EQ(parts.size(), 2U) << lean << " " << y;
      EXPECT_NEAR(parts[0].back().x, pixel(from), kPromised) << lean << " " << y;
      EXPECT_NEAR(parts[1].front().x, pixel(to), kPromised) << lean << " " << y;
    }
  }
}

/// Lines are tested one after the other: what hid the last point hides no other that it does not
/// cover, nor one before it.
TEST(VisibleLines, AreSeenBesideWhatHidTheLastOne) {
  PictureDepths depths(from_above(true), {kSide, kSide});
  add_strip(depths, -0.5, 0, 0);
  add_strip(depths, 0, 0.5, 0);
  EXPECT_TRUE(depths.visible(std::array{dvec3(-0.4, 0, -0.5), dvec3(0.4, 0, -0.5)}, 0).empty());
  EXPECT_EQ(depths.visible(std::array{dvec3(-0.4, 0, 0.5), dvec3(0.4, 0, 0.5)}, 0).size(), 1U);
  EXPECT_TRUE(depths.visible(std::array{dvec3(-0.4, 0, -0.5), dvec3(-0.3, 0, -0.5)}, 0).empty());
  EXPECT_EQ(depths.visible(std::array{dvec3(0.6, 0, -0.5), dvec3(0.9, 0, -0.5)}, 0).size(), 1U);
}

TEST(VisibleLines, NearerOnesAreSeenBeforeWhatTheyLieBehind) {
  PictureDepths depths(from_above(false), {kSide, kSide});
  add_strip(depths, -0.5, 0.5, 0);
  const std::array line = {dvec3(-0.2, 0, -0.01), dvec3(0.2, 0, -0.01)};
  EXPECT_TRUE(depths.visible(line, 0).empty());
  EXPECT_EQ(depths.visible(line, 0.05).size(), 1U);
}

}  // namespace
}  // namespace saddle
