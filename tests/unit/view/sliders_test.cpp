#include "view/model/sliders.h"

#include <gtest/gtest.h>

namespace saddle {
namespace {

TEST(Sliders, HaveRoundSteps) {
  EXPECT_DOUBLE_EQ(step_between(0, 1, kDraggedSteps), 0.01);
  EXPECT_DOUBLE_EQ(step_between(0.1, 1.9, kDraggedSteps), 0.02);
  EXPECT_DOUBLE_EQ(step_between(-5, 5, kDraggedSteps), 0.1);
  EXPECT_DOUBLE_EQ(step_between(0, 360, kDraggedSteps), 5);
  EXPECT_DOUBLE_EQ(step_between(1, -1, kDraggedSteps), 0.02) << "backwards";
  EXPECT_EQ(step_between(2, 2, kDraggedSteps), 0);
}

TEST(Sliders, GiveRoundValuesWithoutSpareDigits) {
  const Slider r{"r", 0.1, 1.9};
  EXPECT_EQ(rounded_text(1.013006, r, kDraggedSteps), "1.02");
  EXPECT_EQ(rounded_text(0.2999999, r, kDraggedSteps), "0.3");
  EXPECT_EQ(rounded_text(1.899, r, kDraggedSteps), "1.9") << "an end that is no whole step";
  EXPECT_EQ(rounded_text(0.102, r, kDraggedSteps), "0.1");
  EXPECT_EQ(rounded_text(217, {"a", 0, 360}, kDraggedSteps), "215");
  EXPECT_EQ(rounded_text(0.0001, {"a", -5, 5}, kDraggedSteps), "0");
}

TEST(Sliders, AreFoundOrMadeAroundTheValue) {
  Scene scene;
  scene.definitions = {{"a", "3"}, {"b", "-0.3"}, {"c", "0"}, {"d", "2*pi"}};
  scene.sliders = {{"a", -1, 7}};
  const auto ends = [&](const char* name, double value) {
    const Slider slider = slider_of(scene, {{}, name}, value);
    return dvec2(slider.min, slider.max);
  };
  EXPECT_EQ(ends("a", 3), dvec2(-1, 7));
  EXPECT_EQ(ends("b", -0.3), dvec2(-1, 1));
  EXPECT_EQ(ends("c", 0), dvec2(0, 1));
  slider_in(scene, {{}, "b"}).max = 2;
  EXPECT_EQ(ends("b", -0.3), dvec2(-1, 2)) << "the scene has one now";
  EXPECT_FALSE(plain_number(scene.definitions[3])) << "2*pi stays as it is";
  EXPECT_EQ(plain_number(scene.definitions[1]), -0.3);
}

}  // namespace
}  // namespace saddle
