#include "scene/model/theme.h"

#include <gtest/gtest.h>

#include <array>

#include "scene/model/assignments.h"
#include "scene/options/options.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

Scene some_scene() {
  Scene scene;
  assign(scene, "z=u*v");
  return scene;
}

double luminance(const Color& color) {
  return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

TEST(Themes, DarkIsTheDefault) {
  Scene scene = some_scene();
  change_theme(scene, Theme::Dark);
  EXPECT_EQ(write_scene(scene), write_scene(some_scene()));
  EXPECT_EQ(themed_surface(Theme::Dark).front, SurfaceSpec{}.front);
  EXPECT_EQ(themed_surface(Theme::Dark).line_color, SurfaceSpec{}.line_color);
}

TEST(Themes, LeaveWhatIsSaidAlone) {
  Scene scene = some_scene();
  scene.background = {1, 0, 0};
  scene.surfaces[0].front.shininess = 5;
  change_theme(scene, Theme::Paper);
  EXPECT_EQ(scene.background, (Color{1, 0, 0}));
  EXPECT_EQ(scene.surfaces[0].front.shininess, 5);
  EXPECT_EQ(scene.surfaces[0].front.diffuse, look_of(Theme::Paper).front.diffuse);
  EXPECT_EQ(scene.surfaces[0].line_color, (Color{0, 0, 0}));
  change_theme(scene, Theme::Dark);
  EXPECT_EQ(scene.surfaces[0].back, kBackMaterial);
}

TEST(Themes, AreWrittenWithWhatDiffersFromThem) {
  Scene scene = some_scene();
  change_theme(scene, Theme::Paper);
  scene.surfaces[0].front.diffuse = kFrontMaterial.diffuse;
  scene.background = {0, 0, 0};
  const std::string text = write_scene(scene);
  EXPECT_EQ(text,
            "theme = \"paper\"\nbackground = \"#000000\"\n\n[[surface]]\nz = \"u*v\"\n"
            "front = { diffuse = [1, 1, 0.5] }\n");
  EXPECT_EQ(write_scene(read_scene({"scene.toml", text})), text);
}

TEST(Themes, GiveWayToKeysOfTheFileEvenIfAnotherIsAskedFor) {
  const std::string text =
      "background = \"black\"\n[[surface]]\nz = \"u\"\nline-color = \"#333333\"\n";
  const Scene scene = read_scene({"scene.toml", text}, Theme::Paper);
  EXPECT_EQ(scene.theme, Theme::Paper);
  EXPECT_EQ(scene.background, (Color{0, 0, 0, 1}));
  EXPECT_EQ(luminance(scene.surfaces[0].line_color), luminance(kLineColor));
  EXPECT_EQ(scene.surfaces[0].front, look_of(Theme::Paper).front);
}

TEST(Themes, HaveInkThatCanBeReadOnTheirBackgrounds) {
  for (const Theme theme : {Theme::Dark, Theme::Light, Theme::Paper}) {
    Scene scene;
    change_theme(scene, theme);
    for (const Color& background : {scene.background, Color{0, 0, 0}, Color{1, 1, 1}}) {
      scene.background = background;
      EXPECT_GT(std::abs(ink_of(scene).x - luminance(background)), 0.7);
    }
  }
  Scene scene;
  scene.background.a = 0;
  EXPECT_EQ(ink_of(scene).x, 0.5) << "on whatever is behind";
}

TEST(Lines, GrowWithThePicture) {
  EXPECT_EQ(fit_line_width({800, 600}), 1);
  EXPECT_EQ(fit_line_width({3200, 2400}), 4);
  EXPECT_EQ(fit_line_width({16384, 600}), 1) << "its height is that of a usual one";
  EXPECT_EQ(fit_line_width({400, 300}), 1) << "thinner lines would fade";
  Scene scene = some_scene();
  EXPECT_EQ(widest_line(scene, {1600, 1200}), 2);
  scene.surfaces[0].line_width = Number(7);
  EXPECT_EQ(line_width_of(scene.surfaces[0], {1600, 1200}), 7);
  EXPECT_EQ(widest_line(scene, {1600, 1200}), 7);
}

TEST(FittingGrid, HasFewerLinesWhereTheyWouldBeTooClose) {
  const auto lines = [](double u, double v, const dvec2& size = {800, 600}) {
    const GridSize fitting = fitting_grid({u, v}, size);
    return std::array{fitting.u, fitting.v};
  };
  EXPECT_EQ(lines(600, 300), (std::array{16, 16}));
  EXPECT_EQ(lines(60, 59), (std::array{16, 6})) << "15 intervals of 4 pixels, 5 of 12";
  EXPECT_EQ(lines(20, 19), (std::array{6, 0})) << "5 intervals of 4 pixels";
  EXPECT_EQ(lines(120, 119, {1600, 1200}), (std::array{16, 6})) << "lines are twice as wide";
}

}  // namespace
}  // namespace saddle
