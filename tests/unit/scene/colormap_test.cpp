#include "scene/model/colormap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "base/error.h"
#include "scene/model/built_colormaps.h"

namespace saddle {
namespace {

void expect_color(const std::string& name, double x, const dvec3& expected, double tolerance) {
  const dvec3 color = colormap_at(name, x);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(color[k], expected[k], tolerance) << name << " at " << x;
}

TEST(Colormaps, HaveTheColoursThatTheirAuthorsPublished) {
  constexpr double kHalfStep = 0.5 / 255;  // tables of eight bits
  expect_color("viridis", 0, {0.267004, 0.004874, 0.329415}, kHalfStep);
  expect_color("viridis", 1, {0.993248, 0.906157, 0.143936}, kHalfStep);
  expect_color("viridis", 128.0 / 255, {0.127568, 0.566949, 0.550556}, kHalfStep);
  expect_color("plasma", 0, {0.050383, 0.029803, 0.527975}, kHalfStep);
  expect_color("inferno", 1, {0.988362, 0.998364, 0.644924}, kHalfStep);
  expect_color("magma", 1, {0.987053, 0.991438, 0.749504}, kHalfStep);
  expect_color("turbo", 0, {0.18995, 0.07176, 0.23217}, kHalfStep);
  expect_color("coolwarm", 0.5, {0.865395, 0.865410, 0.865396}, kHalfStep);
  expect_color("gray", 0.25, {0.25, 0.25, 0.25}, 1e-12);
}

TEST(Colormaps, AreContinuousAndStayAtTheirEnds) {
  for (const std::string& name : colormap_names()) {
    EXPECT_EQ(colormap_at(name, -1), colormap_at(name, 0)) << name;
    EXPECT_EQ(colormap_at(name, 2), colormap_at(name, 1)) << name;
    for (double x = 0; x < 1; x += 0.001) {
      const dvec3 step = glm::abs(colormap_at(name, x + 0.001) - colormap_at(name, x));
      // turbo rises from one end to the other within a seventh of the way
      EXPECT_LT(std::max({step.x, step.y, step.z}), 0.009) << name << " at " << x;
    }
  }
}

TEST(Colormaps, GrowLighterAllTheWayIfTheyAreSequential) {
  for (const char* name : {"viridis", "plasma", "inferno", "magma", "cividis", "gray"}) {
    const auto luma = [&](double x) {
      return glm::dot(colormap_at(name, x), dvec3(0.2126, 0.7152, 0.0722));
    };
    for (double x = 0; x < 0.99; x += 0.02) EXPECT_LT(luma(x), luma(x + 0.02)) << name << x;
  }
}

TEST(Colormaps, AreBuiltAsTheirAuthorDescribesThem) {
  constexpr double kStep = 1.01 / 255;  // the author's table has eight bits
  expect_color("coolwarm", 0, dvec3(59, 76, 192) / 255.0, kStep);
  expect_color("coolwarm", 0.25, dvec3(141, 176, 254) / 255.0, kStep);
  expect_color("coolwarm", 0.75, dvec3(244, 154, 123) / 255.0, kStep);
  expect_color("coolwarm", 1, dvec3(180, 4, 38) / 255.0, kStep);
}

double lightness(const std::string& name, double x) {
  return lab_of(colormap_at(name, x)).x;
}

TEST(Colormaps, ThatDivergeAreLightestInTheMiddle) {
  for (double x = 0; x < 0.49; x += 0.01) {
    EXPECT_LT(lightness("coolwarm", x), lightness("coolwarm", x + 0.01)) << x;
    EXPECT_GT(lightness("coolwarm", 0.5 + x), lightness("coolwarm", 0.51 + x)) << x;
  }
}

TEST(Colormaps, ThatAreCyclicMeetAndHaveEqualStepsOfLightness) {
  EXPECT_LT(glm::distance(colormap_at("twilight", 0), colormap_at("twilight", 1)), 1e-12);
  const double step = lightness("twilight", 0) - lightness("twilight", 0.01);
  EXPECT_GT(step, 1);
  for (double x = 0; x < 0.49; x += 0.01) {
    EXPECT_NEAR(lightness("twilight", x) - lightness("twilight", x + 0.01), step, 1e-2) << x;
    EXPECT_NEAR(lightness("twilight", x), lightness("twilight", 1 - x), 1e-2) << x;
  }
}

TEST(Colormaps, ConvertColoursToCielabAndBack) {
  const dvec3 red = lab_of({1, 0, 0});  // the published values of sRGB's red
  EXPECT_NEAR(red.x, 53.24, 0.01);
  EXPECT_NEAR(red.y, 80.09, 0.03);  // by matrices of more or fewer digits
  EXPECT_NEAR(red.z, 67.20, 0.03);
  for (const dvec3& color : {dvec3(0.2, 0.5, 0.9), dvec3(0.01, 0.02, 0), dvec3(1)}) {
    EXPECT_LT(glm::distance(srgb_of(lab_of(color)), color), 1e-12);
  }
}

TEST(Colormaps, AreFoundByNameOrTheNearestIsNamed) {
  EXPECT_EQ(parse_colormap("--colormap", "plasma"), "plasma");
  try {
    parse_colormap("--colormap", "virdis");
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.hint()).find("did you mean 'viridis'"), std::string::npos);
  }
}

}  // namespace
}  // namespace saddle
