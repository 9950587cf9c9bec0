#include "scene/model/color_scale.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace saddle {
namespace {

Scene coloured(const std::vector<std::pair<std::string, std::string>>& surfaces) {
  Scene scene;
  for (const auto& [color, colormap] : surfaces) {
    SurfaceSpec& spec = scene.surfaces.emplace_back();
    spec.color = color;
    spec.colormap = colormap;
  }
  return scene;
}

using Ranges = std::vector<std::optional<ColorRange>>;

TEST(ColorScales, AreSharedBySurfacesWithTheSameFormulaAndColormap) {
  const Scene scene =
      coloured({{"z", "viridis"}, {"z", "viridis"}, {"z", "magma"}, {"gauss", "viridis"}});
  const Ranges ranges = {ColorRange{0, 1}, ColorRange{-2, 0.5}, ColorRange{3, 4}, ColorRange{5, 6}};
  const auto scales = color_scales(scene, ranges);
  ASSERT_EQ(scales.size(), 3U);
  EXPECT_EQ(scales[0].range.low, -2);
  EXPECT_EQ(scales[0].range.high, 1);
  EXPECT_EQ(&scale_of(scene.surfaces[1], scales), &scales[0]);
  EXPECT_EQ(&scale_of(scene.surfaces[3], scales), &scales[2]);
}

TEST(ColorScales, LeaveOutWhatHasNoColour) {
  const Scene scene = coloured({{"", "viridis"}, {"z", "viridis"}});
  EXPECT_TRUE(color_scales(scene, Ranges{ColorRange{0, 1}, std::nullopt}).empty());
}

TEST(ColorScales, HaveZeroInTheMiddleOfDivergingMaps) {
  const Scene scene = coloured({{"mean", "coolwarm"}});
  const auto scales = color_scales(scene, Ranges{ColorRange{-1, 3}});
  EXPECT_EQ(scales[0].range.low, -3);
  EXPECT_EQ(scales[0].range.high, 3);
  EXPECT_EQ(place_on(scales[0], 0), 0.5);
}

TEST(ColorScales, HaveTheEndsThatAreAskedFor) {
  Scene scene = coloured({{"z", "coolwarm"}, {"z", "viridis"}, {"z", "viridis"}});
  scene.surfaces[0].color_ends = ColorEnds{false, 0, 5};
  scene.surfaces[1].color_ends = ColorEnds{.symmetric = true};
  const auto scales =
      color_scales(scene, Ranges{ColorRange{0, 5}, ColorRange{-1, 3}, ColorRange{-1, 3}});
  ASSERT_EQ(scales.size(), 3U);
  EXPECT_EQ(scales[0].range.low, 0);
  EXPECT_EQ(scales[1].range.low, -3);
  EXPECT_EQ(scales[1].range.high, 3);
  EXPECT_EQ(scales[2].range.low, -1);
}

TEST(ColorScales, SayBeyondWhichEndsThereAreNumbers) {
  const Scene scene = coloured({{"z", "viridis"}, {"z", "viridis"}, {"x", "coolwarm"}});
  const auto scales = color_scales(scene, Ranges{ColorRange{0, 1, false, true}, ColorRange{0, 1},
                                                 ColorRange{-1, 3, true, true}});
  EXPECT_FALSE(scales[0].range.below);
  EXPECT_TRUE(scales[0].range.above);
  EXPECT_FALSE(scales[1].range.below);  // its end is -3 now
  EXPECT_TRUE(scales[1].range.above);
}

TEST(ColorScales, HaveOneNumberInTheMiddle) {
  const Scene scene = coloured({{"1", "viridis"}});
  const auto scales = color_scales(scene, Ranges{ColorRange{1, 1}});
  EXPECT_EQ(place_on(scales[0], 1), 0.5);
}

}  // namespace
}  // namespace saddle
