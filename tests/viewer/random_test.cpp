// Hands that do anything at all, in this process: real window, real OpenGL, made-up events. Under a
// sanitizer it looks for wrong memory and leaks, too.
//
// SADDLE_RANDOM_EVENTS: how many, SADDLE_RANDOM_SEED: which, SADDLE_RANDOM_SECONDS: how long they
// change and undo things.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/heap.h"
#include "base/random.h"
#include "meshing/tessellate.h"
#include "paths.h"
#include "render/picture/canvas.h"
#include "render/picture/renderer.h"
#include "scene/model/gallery.h"
#include "scene/toml/scene_file.h"
#include "view/window/viewer.h"
#include "viewer/display.h"
#include "viewer/gl_names.h"
#include "viewer/random_hand.h"

namespace saddle {
namespace {

constexpr int kSomeEvents = 200;
constexpr int kEventsToRest = 100;
constexpr int kEventsToUndo = 50;
constexpr int kEventsToResize = 30;
constexpr std::chrono::minutes kPatience{2};

std::uint64_t number_from(const char* variable, std::uint64_t otherwise) {
  const char* const text = std::getenv(variable);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : otherwise;
}

ViewerSetup torus() {
  ViewerSetup setup;
  setup.scene = gallery_scene(*find_gallery_entry("torus"));
  setup.tessellate = [](const Scene& scene, std::size_t surface, Detail detail) {
    Scene asked = scene;
    asked.mesh.max_triangles = 50'000;  // it is no test of patience
    if (detail == Detail::Preview) asked.mesh.samples = GridSize{30, 30};
    return tessellate(asked, asked.surfaces[surface], {.picture = true}, 0);
  };
  setup.program = program_path();
  setup.reload = [] { return gallery_scene(*find_gallery_entry("torus")); };
  return setup;
}

/// What stays loaded can be named by whoever looks for leaks: drivers keep a little for ever, and
/// are gone by then.
void keep_drivers_loaded() {
  for (const char* name : {"libGL.so.1", "libGLX.so.0", "libGLX_mesa.so.0", "libX11.so.6",
                           "/usr/lib/x86_64-linux-gnu/dri/swrast_dri.so"}) {
    dlopen(name, RTLD_LAZY | RTLD_NODELETE);
  }
}

class RandomHands : public ViewerHere {
 protected:
  void SetUp() override {
    use_huge_pages();  // as the program does
    ViewerHere::SetUp();
    if (!IsSkipped()) keep_drivers_loaded();
  }

  /// Whether the viewer comes to rest, with t standing still.
  static bool rests(Viewer& viewer, RandomHand& hand) {
    const auto end = std::chrono::steady_clock::now() + kPatience;
    hand.rest();
    while (!viewer.is_at_rest()) {
      if (std::chrono::steady_clock::now() > end) return false;
      viewer.step();
    }
    return true;
  }

  /// What the model says is to be seen, drawn by a renderer that knows nothing of before.
  static Image drawn_afresh(const Model& model) {
    Renderer renderer;
    Canvas canvas;
    Scene scene = model.last_good().scene;
    scene.picture.shading = model.scene().picture.shading;
    for (std::size_t i = 0; i < model.meshes().size(); ++i) {
      renderer.set_surface(scene, i, model.meshes()[i]->mesh);
    }
    const PictureSettings& picture = model.scene().picture;
    const Scene drawn = model.drawn_scene();
    const int finest = std::min(2, picture.antialias);
    canvas.draw(renderer, {drawn, model.grip().fitted, model.look()}, picture.width, picture.height,
                finest, finest);
    return canvas.read();
  }

  static std::size_t wrong_bytes(const Image& a, const Image& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i) {
      count += a.rgba[i] == b.rgba[i] ? 0 : 1;
    }
    return count;
  }

  static std::string describe(const Viewer& viewer) {
    const Model& model = viewer.model();
    return std::string(model.view().playing ? "playing " : "") +
           (model.is_meshing() ? "meshing " : "") + (model.next_pass() ? "refining " : "") +
           (viewer.drawing().is_at_rest() ? "" : "drawing ") + write_scene(model.scene());
  }

  /// Pixels of the picture that the screen has otherwise, where nothing lies over it. One more or
  /// less of 255 is rounding.
  int wrong_pixels_on_screen(const Viewer& viewer, const Image& picture) const {
    const Model& model = viewer.model();
    const bool has_panel = model.view().panel;
    constexpr int kNarrow = 400;  // of a window in which the panel is narrower, too
    const bool is_covered = !viewer.message().empty() || (model.error() && !has_panel);
    if (is_covered || (has_panel && picture.width < kNarrow)) return 0;
    const Image screen = screenshot();
    const int left = has_panel ? kPanelWidth : 0;
    constexpr int kRim = 2;  // of the panel
    int wrong = 0;
    for (int y = 0; y < std::min(picture.height, screen.height); ++y) {
      for (int x = kRim; x < std::min(picture.width, screen.width - left); ++x) {
        const auto* const a = picture.pixel(x, y);
        const auto* const b = screen.pixel(left + x, y);
        const auto is_other = [&](int c) { return std::abs(a[c] - b[c]) > 1; };
        wrong += is_other(0) || is_other(1) || is_other(2) ? 1 : 0;
      }
    }
    ++compared_screens_;
    constexpr int kMark = 200;  // of a picked point
    return model.picked() && wrong < kMark ? 0 : wrong;
  }
  mutable int compared_screens_ = 0;

  /// From a pixel to more than the screen, a quarter of the times; where it was, the others.
  void resize(std::uint64_t seed) const {
    const auto below = [&](int end) { return static_cast<int>(end * random_unit(seed++)); };
    const bool any = below(4) == 0;
    const int width = any ? 1 + below(1500) : 1080;
    const int height = any ? 1 + below(900) : 600;
    act("search --class saddle windowsize " + std::to_string(width) + " " + std::to_string(height));
  }
};

/// Megabytes of memory that the process has.
double megabytes() {
  std::size_t all = 0;
  std::size_t resident = 0;
  std::ifstream("/proc/self/statm") >> all >> resident;
  return static_cast<double>(resident) * 4096 / (1 << 20);
}

/// What undo and redo are about: all but the window's size.
std::string undone_things(const Model& model) {
  Scene scene = model.scene();
  scene.picture.width = scene.picture.height = 1;
  const ViewState& view = model.view();
  const std::string looks = std::string(view.grid ? "g" : "") + (view.wireframe ? "w" : "") +
                            (view.normals ? "n" : "") + (view.turntable ? "t" : "") +
                            (view.panel ? "p" : "");
  return write_scene(scene) + looks;
}

/// Undoes or redoes all that there is, or so many changes; how many they were.
int go_all_the_way(Viewer& viewer, RandomHand& hand, const std::string& key, int most = 2000) {
  int count = 0;
  const auto has_more = [&] {
    const History& history = viewer.model().history();
    return key == "Ctrl-Z" ? history.has_past() : history.has_future();
  };
  for (; has_more() && count < most; ++count) {
    hand.press_key_named(key);
    while (viewer.has_events()) viewer.step();
  }
  return count;
}

TEST_F(RandomHands, UndoAllThatTheyDid) {
  const std::uint64_t seed = number_from("SADDLE_RANDOM_SEED", 1) + 1000;
  const auto events = static_cast<int>(number_from("SADDLE_RANDOM_EVENTS", kSomeEvents / 2));
  const std::chrono::seconds seconds(number_from("SADDLE_RANDOM_SECONDS", 0));
  Viewer viewer(torus());
  const std::jthread waker([](const std::stop_token& end) {
    while (!end.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      Window::wake();
    }
  });
  RandomHand hand(viewer, seed);
  ASSERT_TRUE(rests(viewer, hand));
  const std::string first = undone_things(viewer.model());
  while (!viewer.is_tidy()) viewer.step();
  const double memory = megabytes();
  const auto end = std::chrono::steady_clock::now() + seconds;
  const auto goes_on = [&](int i) {
    return seconds.count() > 0 ? std::chrono::steady_clock::now() < end : i < events;
  };
  int undone = 0;
  for (int i = 0; goes_on(i) || i % kEventsToUndo != 0; ++i) {
    hand.act();
    viewer.step();
    ASSERT_FALSE(viewer.is_to_end()) << "deed " << i << " of seed " << seed;
    if (i % kEventsToUndo != kEventsToUndo - 1) continue;
    ASSERT_TRUE(rests(viewer, hand))
        << "stuck after " << i << " deeds of seed " << seed << ": " << describe(viewer);
    const std::string last = undone_things(viewer.model());
    const int count = go_all_the_way(viewer, hand, "Ctrl-Z");
    ASSERT_EQ(undone_things(viewer.model()), first) << "after " << i << " deeds of seed " << seed;
    ASSERT_EQ(go_all_the_way(viewer, hand, "Ctrl-Shift-Z", count), count);
    ASSERT_EQ(undone_things(viewer.model()), last) << "after " << i << " deeds of seed " << seed;
    go_all_the_way(viewer, hand, "Ctrl-Z");
    undone += count;
  }
  EXPECT_GT(undone, events / 4);
  if (seconds.count() == 0) return;
  while (!viewer.is_tidy()) viewer.step();
  std::printf("%d changes undone; memory %.0f MB, %.2f times the start's\n", undone, megabytes(),
              megabytes() / memory);
  EXPECT_LE(megabytes(), 1.5 * memory);
}

TEST_F(RandomHands, LeaveAPictureThatIsRightAndNothingBehind) {
  const std::uint64_t seed = number_from("SADDLE_RANDOM_SEED", 1);
  const auto events = static_cast<int>(number_from("SADDLE_RANDOM_EVENTS", kSomeEvents));
  std::optional<GlNames> names;
  {
    Viewer viewer(torus());
    names.emplace();
    // Who waits for what never comes must not wait for ever.
    const std::jthread waker([](const std::stop_token& end) {
      while (!end.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        Window::wake();
      }
    });
    RandomHand hand(viewer, seed);
    for (int i = 0; i < events; ++i) {
      hand.act();
      viewer.step();
      if (i % kEventsToResize == kEventsToResize - 1) resize(seed + static_cast<unsigned>(i));
      if (i % kEventsToRest != kEventsToRest - 1) continue;
      ASSERT_TRUE(rests(viewer, hand))
          << "stuck after " << i << " deeds of seed " << seed << ": " << describe(viewer);
      while (!viewer.message().empty()) viewer.step();  // it covers the picture
      const Image picture = viewer.drawing().read();
      const Image afresh = drawn_afresh(viewer.model());
      ASSERT_TRUE(picture.rgba == afresh.rgba)
          << "after " << i << " deeds of seed " << seed << ": " << wrong_bytes(picture, afresh)
          << " bytes of " << picture.rgba.size() << " differ: " << describe(viewer);
      ASSERT_EQ(wrong_pixels_on_screen(viewer, picture), 0)
          << "after " << i << " deeds of seed " << seed;
    }
    EXPECT_GT(compared_screens_, 0);
    EXPECT_GT(names->made(), 10) << "the count sees what is made";
  }
  EXPECT_EQ(names->live(), 0);
}

TEST_F(RandomHands, CloseTheWindowAtAnyMoment) {
  for (int steps = 0; steps < 12; steps += 2) {
    std::optional<GlNames> names;
    {
      Viewer viewer(torus());
      names.emplace();
      RandomHand hand(viewer, static_cast<std::uint64_t>(steps));
      for (int i = 0; i < steps; ++i) {
        hand.act();
        viewer.step();
      }
    }
    EXPECT_EQ(names->live(), 0);
  }
}

}  // namespace
}  // namespace saddle
