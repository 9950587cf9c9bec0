// Hands that do anything at all, in this process: real window, real OpenGL, made-up events. Under a
// sanitizer it looks for wrong memory and leaks, too.
//
// SADDLE_RANDOM_EVENTS: how many, SADDLE_RANDOM_SEED: which, SADDLE_RANDOM_SECONDS: how long they
// change and undo things.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "base/error.h"
#include "base/random.h"
#include "meshing/tessellate.h"
#include "paths.h"
#include "random_formula.h"
#include "render/picture/canvas.h"
#include "render/picture/renderer.h"
#include "scene/model/gallery.h"
#include "scene/toml/scene_file.h"
#include "view/window/viewer.h"
#include "viewer/display.h"
#include "viewer/gl_names.h"

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

/// GLFW's numbers for keys that fields understand.
constexpr int kKeyA = 65;
constexpr int kKeyEscape = 256;
constexpr int kKeyReturn = 257;
constexpr int kKeyBackspace = 259;
constexpr int kKeyControl = 341;
constexpr int kModControl = 2;

/// Makes up what a person might do, and more.
class RandomHand {
 public:
  RandomHand(Viewer& viewer, std::uint64_t seed)
      : viewer_(viewer), formula_(seed), seed_(seed << 32U) {}

  /// One deed, which may be several events.
  void act() {
    switch (below(12)) {
      case 0:
      case 1:
        return drag();
      case 2:
      case 3:
        return scroll();
      case 4:
        return click(anywhere(), 2);
      case 5:
        return click({20.0 + below(260), 20.0 + below(560)}, 1);  // into the panel
      case 6:
      case 7:
        return enter_formula();
      case 8:
        return type(formula_(2));
      case 9:
        return move(anywhere());
      default:
        return press_key();
    }
  }

  /// Lets go, leaves fields and lists, stops t, and takes away what is no part of the scene.
  void rest() {
    for (int which = 0; which < 3; ++which) button(Event::Kind::Release, which);
    for (int i = 0; i < 3; ++i) {  // lists, help, the start page
      for (const bool down : {true, false}) key(kKeyEscape, 0, down);
    }
    click({700, 300}, 1);
    while (viewer_.has_events()) viewer_.step();
    if (viewer_.model().view().playing || viewer_.model().played()) press_key_named("Space");
    if (viewer_.model().view().normals) press_key_named("n");
  }

  void press_key_named(const std::string& name) {
    Event event = at_pointer(name.size() == 1 ? Event::Kind::Character : Event::Kind::KeyDown);
    event.key = name;
    event.code = name.size() == 1 ? name[0] : 0;
    viewer_.receive(event);
  }

 private:
  int below(int end) { return static_cast<int>(end * random_unit(seed_++)); }
  dvec2 anywhere() { return {double(below(1080)), double(below(600))}; }

  Event at_pointer(Event::Kind kind) const {
    Event event;
    event.kind = kind;
    event.place = pointer_;
    return event;
  }

  void move(const dvec2& place) {
    pointer_ = place;
    viewer_.receive(at_pointer(Event::Kind::Move));
  }

  void button(Event::Kind kind, int button, bool shift = false) {
    Event event = at_pointer(kind);
    event.button = button;
    event.shift = shift;
    viewer_.receive(event);
  }

  void click(const dvec2& place, int times) {
    move(place);
    for (int i = 0; i < times; ++i) {
      button(Event::Kind::Press, 0);
      button(Event::Kind::Release, 0);
    }
  }

  void drag() {
    const int which = below(3);
    move(anywhere());
    button(Event::Kind::Press, which, below(4) == 0);
    for (int i = below(6); i >= 0; --i) {
      move(anywhere());
      if (below(8) == 0) press_key();
      viewer_.step();
    }
    if (below(20) != 0) button(Event::Kind::Release, which);
  }

  void scroll() {
    move(anywhere());
    for (int i = below(4); i >= 0; --i) {
      Event event = at_pointer(Event::Kind::Scroll);
      event.notches = 4 * random_unit(seed_++) - 2;
      viewer_.receive(event);
    }
  }

  void key(int code, int mods, bool down) {
    Event event = at_pointer(down ? Event::Kind::KeyDown : Event::Kind::KeyUp);
    event.code = code;
    event.mods = mods;
    if (down && code == kKeyEscape) event.key = "Escape";
    if (down && code == kKeyReturn) event.key = "Return";
    viewer_.receive(event);
  }

  void type(const std::string& text) {
    for (const char c : text) press_key_named(std::string(1, c));
  }

  /// In place of what is in one of the fields at the top.
  void enter_formula() {
    click({200, 65.0 + 25 * below(6)}, 1);
    key(kKeyControl, kModControl, true);
    key(kKeyA, kModControl, true);
    key(kKeyA, kModControl, false);
    key(kKeyControl, 0, false);
    type(formula_(below(3)));
    if (below(3) == 0) {
      key(kKeyBackspace, 0, true);
      key(kKeyBackspace, 0, false);
    }
  }

  /// Any but those that end the program. Those without a key are found by their names.
  void press_key() {
    const auto table = action_table();
    const ActionRow& row = table[below(static_cast<int>(table.size()))];
    if (row.action == Action::Quit) return;
    if (*row.key != 0 && below(4) != 0) return press_key_named(row.key);
    if (row.menu == Menu::None) return;
    press_key_named("Ctrl-P");
    settle();
    type(row.name);
    settle();
    for (const bool down : {true, false}) key(kKeyReturn, 0, down);
    settle();
  }

  void settle() {
    while (viewer_.has_events()) viewer_.step();
    viewer_.step();
  }

  Viewer& viewer_;
  testing::RandomFormula formula_;
  std::uint64_t seed_;
  dvec2 pointer_{0, 0};
};

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

class RandomHands : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    keep_drivers_loaded();
    setenv("DISPLAY", display().c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_);  // which gets the files that are saved
  }
  void TearDown() override {
    if (!before_.empty()) std::filesystem::current_path(before_);
    ViewerTest::TearDown();
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

  static std::string describe(const Viewer& viewer) {
    const Model& model = viewer.model();
    return std::string(model.view().playing ? "playing " : "") +
           (model.is_meshing() ? "meshing " : "") + (model.next_pass() ? "refining " : "") +
           (viewer.drawing().is_at_rest() ? "" : "drawing ") + write_scene(model.scene());
  }

  /// From a pixel to more than the screen, a quarter of the times; where it was, the others.
  void resize(std::uint64_t seed) const {
    const auto below = [&](int end) { return static_cast<int>(end * random_unit(seed++)); };
    const bool any = below(4) == 0;
    const int width = any ? 1 + below(1500) : 1080;
    const int height = any ? 1 + below(900) : 600;
    act("search --class saddle windowsize " + std::to_string(width) + " " + std::to_string(height));
  }

 private:
  std::filesystem::path before_;
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
    ASSERT_TRUE(rests(viewer, hand)) << "stuck after " << i << " deeds of seed " << seed;
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
      ASSERT_EQ(viewer.drawing().read().rgba, drawn_afresh(viewer.model()).rgba)
          << "after " << i << " deeds of seed " << seed;
    }
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
