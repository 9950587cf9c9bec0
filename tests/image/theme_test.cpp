// Whether the sides, lines and backgrounds of themes can be told apart in the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "image/lighting_reference.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

double luminance(const dvec3& rgb) {
  return glm::dot(glm::min(rgb, dvec3(1)), dvec3(0.2126, 0.7152, 0.0722));
}

struct Shades {
  double darkest = 1;
  double brightest = 0;
};

/// Of a side under the default lights, where the eye meets it at up to so many degrees.
Shades shades_of(const Material& material, double degrees) {
  Shades shades;
  constexpr int kSteps = 90;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j < 4 * kSteps; ++j) {
      const double tilt = degrees * std::numbers::pi / 180 * i / kSteps;
      const double around = 2 * std::numbers::pi * j / (4 * kSteps);
      const dvec3 n(std::sin(tilt) * std::cos(around), std::sin(tilt) * std::sin(around),
                    std::cos(tilt));
      const double shade =
          luminance(lit_color({dvec3(0, 0, -10), n, dvec3(0, 0, 1)}, material, default_lights()));
      shades.darkest = std::min(shades.darkest, shade);
      shades.brightest = std::max(shades.brightest, shade);
    }
  }
  return shades;
}

double luminance(const Color& color) {
  return luminance(dvec3(color.r, color.g, color.b));
}

TEST(Paper, IsReadableInGrey) {
  const ThemeLook& paper = look_of(Theme::Paper);
  constexpr double kApart = 0.1;
  const Shades front = shades_of(paper.front, 60);
  const Shades back = shades_of(paper.back, 60);
  EXPECT_EQ(luminance(paper.lines), 0);
  EXPECT_EQ(paper.dark_ink, dvec3(0));
  EXPECT_EQ(luminance(paper.background), 1);
  EXPECT_GT(back.darkest, luminance(paper.lines) + kApart);
  EXPECT_GT(front.darkest, back.brightest + kApart);
  EXPECT_GT(luminance(paper.background), front.brightest + kApart);
}

/// Of a side that faces the eye: its lines and the background.
TEST(Themes, HaveBacksThatCanBeRead) {
  for (const Theme theme : {Theme::Dark, Theme::Light, Theme::Paper}) {
    const ThemeLook& look = look_of(theme);
    for (const Material& side : {look.front, look.back}) {
      const Shades facing = shades_of(side, 30);
      const double lines = luminance(look.lines);
      EXPECT_GT(facing.darkest, lines + 0.1) << static_cast<int>(theme);
      const double background = luminance(look.background);
      EXPECT_TRUE(facing.darkest > background + 0.1 || facing.brightest < background - 0.1)
          << static_cast<int>(theme);
    }
  }
}

TEST(Themes, TellLevelLinesFromTheGridAndFromTheSides) {
  const dvec2 size(800, 600);
  for (const Theme theme : {Theme::Dark, Theme::Light, Theme::Paper}) {
    const SurfaceSpec surface = themed_surface(theme);
    EXPECT_GE(contour_width_of(surface, size), 2 * line_width_of(surface, size));
    const Color& lines = contour_color_of(surface, theme);
    for (const Material& side : {surface.front, surface.back}) {
      EXPECT_GT(shades_of(side, 30).darkest, luminance(lines) + 0.1) << static_cast<int>(theme);
    }
    // Paper is for printers without colours.
    EXPECT_EQ(lines == surface.line_color, theme == Theme::Paper);
  }
}

}  // namespace
}  // namespace saddle
