// When and how the window paints what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

#include "export/formats/load_scene.h"
#include "paths.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

/// So many of a picture of 640x360 are no seam.
constexpr int kFewPixels = 20;

int differing_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  }
  return count;
}

/// The scene of see-through surfaces in a picture of this size.
ViewerSetup see_through(int width, int height) {
  ViewerSetup setup;
  setup.scene = load_scene(source_folder() + "/examples/see-through.toml");
  setup.scene.picture.width = width;
  setup.scene.picture.height = height;
  return setup;
}

TEST_F(Workplace, IsLightWhereItsSceneIs) {
  open({"z=u*v"});
  const auto brightness = [&] { return int{screenshot().pixel(200, 590)[0]}; };
  EXPECT_TRUE(eventually([&] { return brightness() < 60; }));
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  start({"z=u*v", "--theme", "paper"});
  EXPECT_TRUE(eventually([&] { return brightness() > 200; }));
}

TEST_F(Workplace, ShowsAllOfALongFormulaWhileItIsEdited) {
  const auto changes = [&] {  // below the field of z
    const Image before = screenshot();
    enter_field(2);
    settled_picture();
    const Image after = screenshot();
    int count = 0;
    for (int y = 130; y < 150; ++y) {
      for (int x = 8; x < 290; ++x) {
        count += std::equal(before.pixel(x, y), before.pixel(x, y) + 4, after.pixel(x, y)) ? 0 : 1;
      }
    }
    return count;
  };
  open({"z=u*v"});
  EXPECT_LT(changes(), 20);
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  open({"z=u*v+0*(u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v+u+v)"});
  EXPECT_GT(changes(), 200);
}

TEST_F(Workplace, StaysAtRestWhereNothingCouldPlay) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  key(viewer, "Space");
  EXPECT_FALSE(viewer.model().view().playing);
  EXPECT_TRUE(rests(viewer));
}

TEST_F(Workplace, TellsTheTimeOfWhatMovesAlone) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(until(viewer, [&] { return viewer.drawing().figures().frames > 0; }));
  EXPECT_FALSE(viewer.drawing().figures().moving_ms)
      << "shaders are compiled for the first picture";
}

TEST_F(Workplace, RefinesAPictureThatRestsPartByPart) {
  Viewer viewer(see_through(640, 360));
  int steps = 0;
  ASSERT_TRUE(until(viewer, [&] { return ++steps > 0 && viewer.is_at_rest(); }));
  const Image shown = viewer.drawing().read();
  const Model& model = viewer.model();
  Renderer renderer;
  Canvas canvas;
  renderer.set_surface(model.last_good().scene, 0, model.meshes()[0]->mesh);
  const Scene drawn = model.drawn_scene();
  canvas.draw(renderer, {drawn, model.grip().fitted, model.look()}, shown.width, shown.height, 2,
              2);
  // Layers as near to each other as their depths are rounded may change places.
  EXPECT_LE(differing_pixels(shown, canvas.read()), kFewPixels) << "no seams between parts";
}

TEST_F(Workplace, AnswersKeysBetweenParts) {
  Viewer viewer(see_through(800, 600));
  ASSERT_TRUE(rests(viewer));
  type(viewer, "g");  // another picture
  // It is refined after a while, and a key comes meanwhile.
  ASSERT_TRUE(until(viewer, [&] { return viewer.drawing().is_refining(); }));
  const std::size_t frames = viewer.spent().frames;
  key(viewer, "F1");
  EXPECT_TRUE(viewer.drawing().is_refining()) << "the help did not wait for the picture";
  EXPECT_GT(viewer.spent().frames, frames);
  EXPECT_TRUE(rests(viewer));
}

}  // namespace
}  // namespace saddle
