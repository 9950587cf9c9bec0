// When and how the window paints what it shows.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "export/formats/load_scene.h"
#include "meshing/tessellate.h"
#include "paths.h"
#include "render/gl/gl.h"
#include "sanitized.h"
#include "viewer/gl_names.h"
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

/// While it lives, each drawing takes longer than there is time for in a step.
class SlowDrawing {
 public:
  SlowDrawing() {
    use_ = glad_glUseProgram;
    glad_glUseProgram = [](GLuint program) {
      if (program == 0) std::this_thread::sleep_for(std::chrono::milliseconds(30));  // at its end
      use_(program);
    };
  }
  ~SlowDrawing() { glad_glUseProgram = use_; }
  SlowDrawing(const SlowDrawing&) = delete;
  SlowDrawing& operator=(const SlowDrawing&) = delete;

 private:
  static inline PFNGLUSEPROGRAMPROC use_ = nullptr;
};

/// The scene of see-through surfaces in a picture of this size.
ViewerSetup see_through(int width, int height) {
  ViewerSetup setup;
  setup.scene = load_scene(source_folder() + "/examples/see-through.toml");
  setup.scene.picture.width = width;
  setup.scene.picture.height = height;
  return setup;
}

/// Counts the pixels that are copied from one framebuffer to another while it lives, as far as
/// scissors let it. One at a time.
class Copies {
 public:
  Copies() {
    pixels_ = 0;
    blit_ = glad_glBlitFramebuffer;
    glad_glBlitFramebuffer = [](GLint x0, GLint y0, GLint x1, GLint y1, GLint to_x0, GLint to_y0,
                                GLint to_x1, GLint to_y1, GLbitfield what, GLenum filter) {
      std::array<GLint, 4> box{};
      glGetIntegerv(GL_SCISSOR_BOX, box.data());
      pixels_ += box[2] * box[3];
      blit_(x0, y0, x1, y1, to_x0, to_y0, to_x1, to_y1, what, filter);
    };
  }
  ~Copies() { glad_glBlitFramebuffer = blit_; }
  Copies(const Copies&) = delete;
  Copies& operator=(const Copies&) = delete;

  static int pixels() { return pixels_; }

 private:
  static inline int pixels_ = 0;
  static inline PFNGLBLITFRAMEBUFFERPROC blit_ = nullptr;
};

Event event_at(Event::Kind kind, const dvec2& place) {
  Event event;
  event.kind = kind;
  event.place = place;
  return event;
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

TEST_F(Workplace, CountsNoSecondsOfMeshingWhileItPlays) {
  if (kIsSanitized) GTEST_SKIP() << "a mesh and its picture take a second";
  Scene scene = entry("torus");
  scene.surfaces[0].z += "+t/1000";
  ViewerSetup setup = setup_of(std::move(scene));
  setup.tessellate = [](const Scene& asked, std::size_t surface, Detail) {
    Scene coarse = asked;
    coarse.mesh.samples = GridSize{8, 8};
    std::this_thread::sleep_for(std::chrono::milliseconds(40));  // a request always waits
    return tessellate(coarse, coarse.surfaces[surface], {.picture = true}, 1);
  };
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  key(viewer, "Space");
  ASSERT_TRUE(viewer.model().view().playing);
  const auto end = std::chrono::steady_clock::now() + std::chrono::milliseconds(1500);
  while (std::chrono::steady_clock::now() < end) {
    viewer.step();
    ASSERT_FALSE(viewer.model().meshing_seconds()) << "no mesh takes so long";
  }
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

TEST_F(Workplace, DrawsItsPanelIntoNoPicture) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  type(viewer, "g");
  ASSERT_TRUE(rests(viewer));
  const Image before = viewer.drawing().read();
  const SlowDrawing slow;
  for (int i = 0; i < 4; ++i) type(viewer, "g");  // until it is drawn coarsely first
  ASSERT_FALSE(viewer.drawing().is_at_rest());
  Event any_key;
  any_key.kind = Event::Kind::KeyDown;
  any_key.place = {1, 1};
  // The first of two keys is answered before the picture, the second after a part of it.
  while (!viewer.drawing().is_at_rest()) {
    for (int step = 0; step < 5 && !viewer.drawing().is_at_rest(); ++step) {
      if (step >= 3) viewer.receive(any_key);
      viewer.step();
    }
  }
  ASSERT_TRUE(rests(viewer));
  EXPECT_EQ(differing_pixels(viewer.drawing().read(), before), 0);
}

TEST_F(Workplace, CopiesOnlyWhatHasChangedToTheWindow) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const Image before = picture();
  const Copies copies;
  const std::size_t frames = viewer.spent().frames;
  key(viewer, "Tab");
  ASSERT_TRUE(rests(viewer));
  EXPECT_GT(viewer.spent().frames, frames);
  constexpr int kRim = 10'000;  // of the panel, in a few frames
  EXPECT_LT(copies.pixels(), kRim) << "the panel alone is another";
  key(viewer, "Escape", kEscape);
  key(viewer, "F1");
  ASSERT_TRUE(rests(viewer));
  EXPECT_NE(picture().rgba, before.rgba);
  key(viewer, "F1");
  ASSERT_TRUE(rests(viewer));
  EXPECT_EQ(picture().rgba, before.rgba) << "nothing of the help is left";
  EXPECT_GT(copies.pixels(), kRim);
}

TEST_F(Workplace, AnswersAKeyBeforeThePictureThatMoves) {
  Viewer viewer(see_through(800, 600));
  ASSERT_TRUE(rests(viewer));
  viewer.receive(event_at(Event::Kind::Press, {700, 300}));
  while (viewer.has_events()) viewer.step();
  const auto pictures = [&] { return viewer.drawing().figures().frames; };
  for (int i = 0; i < 6; ++i) {
    const std::size_t drawn = pictures();
    viewer.receive(event_at(Event::Kind::Move, {710.0 + 10 * i, 300}));
    receive_key(viewer, "F1");
    const std::size_t frames = viewer.spent().frames;
    while (viewer.spent().frames == frames) viewer.step();
    if (i % 2 == 0) {
      EXPECT_EQ(pictures(), drawn) << "the help did not wait for the picture";
    }
    ASSERT_TRUE(until(viewer, [&] { return pictures() > drawn; })) << "nor is it forgotten";
  }
  EXPECT_TRUE(rests(viewer));
}

TEST_F(Workplace, DrawsAnEditWithItsMesh) {
  if (kIsSanitized) GTEST_SKIP() << "no mesh comes as soon as the window waits for it";
  ViewerSetup setup = setup_of(entry("torus"));
  setup.tessellate = [](const Scene& scene, std::size_t surface, Detail) {
    Scene asked = scene;
    asked.mesh.samples = GridSize{8, 8};
    return tessellate(asked, asked.surfaces[surface], {.picture = true}, 1);
  };
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, {200, 115});
  constexpr int kEnd = 269;
  key(viewer, "", kEnd);
  type(viewer, "+0.");
  int together = 0;
  for (int i = 0; i < 8; ++i) {  // a machine that does other things, too, may take long for some
    ASSERT_TRUE(rests(viewer));
    const auto meshes = viewer.model().meshes();
    const std::size_t pictures = viewer.drawing().figures().frames;
    receive_text(viewer, "0");
    ASSERT_TRUE(until(viewer, [&] { return viewer.drawing().figures().frames > pictures; }));
    together += viewer.model().meshes() != meshes ? 1 : 0;
  }
  EXPECT_GT(together, 0) << "no picture before that of the edit";
}

/// A coarse picture is magnified: its rim must not take colours from beside it.
TEST_F(Workplace, ShowsNothingOfEarlierPicturesAtTheRim) {
  constexpr int kSide = 160;
  Viewer viewer(setup_of(entry("torus")));  // its context
  ASSERT_TRUE(rests(viewer));
  Scene scene;
  scene.background = {1, 1, 1};
  scene.mesh.samples = GridSize{2, 2};
  scene.surfaces.emplace_back().z = "u*v";
  scene.surfaces[0].visible = false;  // but for its background
  const Tessellation surface = tessellate(scene, scene.surfaces[0], {.picture = true}, 1);
  Renderer renderer;
  renderer.set_surface(scene, 0, surface.mesh);
  const FittedCamera camera = fit_camera(scene.camera, surface.mesh.bounds, 1);
  Canvas canvas;
  canvas.draw(renderer, {scene, camera, {}}, kSide, kSide, 1, 2);
  scene.background = {0, 0, 0};
  canvas.draw(renderer, {scene, camera, {}}, kSide, kSide, 0.125, 2);
  canvas.show(0, kSide, {0, 0, kSide, kSide});
  std::vector<unsigned char> rim(std::size_t{4} * kSide);
  glReadPixels(0, kSide - 1, kSide, 1, GL_RGBA, GL_UNSIGNED_BYTE, rim.data());
  for (std::size_t x = 0; x < kSide; ++x) EXPECT_EQ(rim[4 * x], 0) << "above, at " << x;
  glReadPixels(kSide - 1, 0, 1, kSide, GL_RGBA, GL_UNSIGNED_BYTE, rim.data());
  for (std::size_t y = 0; y < kSide; ++y) EXPECT_EQ(rim[4 * y], 0) << "at the right, at " << y;
}

TEST_F(Workplace, ForgetsProgramsOfFormulasThatAreGone) {
  Viewer viewer(setup_of(entry("torus")));  // its context
  const CountedPrograms programs;
  Renderer renderer;
  Canvas canvas;
  const std::vector<std::string> functions{"sin", "cos", "tan", "atan", "exp", "sinh", "cosh"};
  int most = 0;
  int made = 0;
  for (const std::string& f : functions) {
    for (const std::string& g : functions) {
      Scene scene;
      scene.picture.shading = Shading::Exact;
      scene.mesh.samples = GridSize{2, 2};
      scene.surfaces.emplace_back().z = "u*v+" + f + "(" + g + "(u))";
      const Tessellation surface = tessellate(scene, scene.surfaces[0], {.picture = true}, 1);
      renderer.set_surface(scene, 0, surface.mesh);
      const FittedCamera camera = fit_camera(scene.camera, surface.mesh.bounds, 1);
      canvas.draw(renderer, {scene, camera, {}}, 16, 16, 1, 1);
      ++made;
      most = std::max(most, programs.live());
    }
  }
  constexpr int kFew = 12;
  EXPECT_LE(most, kFew) << made << " formulas, two programs each";
}

}  // namespace
}  // namespace saddle
