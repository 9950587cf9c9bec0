// Text typed into the window: all of it arrives in its field, and none of it is taken as a command.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "export/formats/load_scene.h"
#include "meshing/tessellate.h"
#include "scene/model/gallery.h"
#include "view/window/viewer.h"
#include "viewer/display.h"

namespace saddle {
namespace {

constexpr std::chrono::seconds kPatience{20};

/// The z field is the third.
constexpr int kFieldOfZ = 2;
constexpr dvec2 kFieldOfX{200, 65};

class Typing : public ViewerTest {
 protected:
  /// The z that the window saves once the picture has the keyboard.
  std::string saved_z() {
    click(700, 550);
    act("key S");
    ++saves_;
    const std::string name =
        saves_ == 1 ? "saddle.toml" : "saddle-" + std::to_string(saves_) + ".toml";
    if (!eventually([&] { return std::filesystem::exists(path(name)); })) return "not saved";
    return load_scene(path(name)).surfaces.at(0).z;
  }
  bool has_written_picture() const { return std::filesystem::exists(path("saddle.png")); }

 private:
  int saves_ = 0;
};

TEST_F(Typing, GoesOnWhileAMessageIsShown) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  settled_picture();
  const Image before = error_strip();
  act("key ctrl+a");
  act("type --delay 20 'sqrt(u-2)'");
  ASSERT_TRUE(eventually([&] { return error_strip().rgba != before.rgba; })) << "no message";
  settled_picture();
  for (const std::string part : {"+s", "q", "rt(2)"}) {
    act("type --delay 20 '" + part + "'");
    settled_picture();
  }
  EXPECT_EQ(saved_z(), "sqrt(u-2)+sqrt(2)");
  EXPECT_FALSE(has_written_picture());
}

TEST_F(Typing, GoesFromFieldToFieldByTab) {
  open({"z=u*v"});
  click(700, 550);
  act("key Tab key ctrl+a type 2*u");
  act("key Tab key ctrl+a type 3*v");
  act("key Tab key Tab key shift+Tab key ctrl+a type u+v");
  EXPECT_EQ(saved_z(), "u+v");
  const SurfaceSpec spec = load_scene(path("saddle.toml")).surfaces.at(0);
  EXPECT_EQ(spec.x, "2*u");
  EXPECT_EQ(spec.y, "3*v");
}

TEST_F(Typing, GoesOnAfterReturn) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  act("type '+v'");
  act("key Return");
  act("type '+sqrt(u)'");
  EXPECT_EQ(saved_z(), "u*v+v+sqrt(u)");
  EXPECT_FALSE(has_written_picture());
}

TEST_F(Typing, LeavesWhatReturnConfirmed) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  act("type '+v'");
  act("key Return");
  act("type '+u'");
  act("key Escape");
  EXPECT_EQ(saved_z(), "u*v+v");
}

TEST_F(Typing, AddsDefinitionsInARow) {
  open({"z=u*v"});
  enter_new_definition();
  act("type 'aa=2'");
  act("key Return");
  settled_picture();
  act("type 'bb=3'");
  act("key Return");
  click(700, 550);
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  const Scene scene = load_scene(path("saddle.toml"));
  ASSERT_EQ(scene.definitions.size(), 2U);
  EXPECT_EQ(scene.definitions[0].name + "=" + scene.definitions[0].text, "aa=2");
  EXPECT_EQ(scene.definitions[1].name + "=" + scene.definitions[1].text, "bb=3");
}

TEST_F(Typing, KeepsEditingKeysInTheirOrder) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  act("key ctrl+a");
  act("type --delay 0 '1+2'");
  // GLFW drops a second press of a key within a millisecond.
  act("key --delay 4 BackSpace 3 Left Left BackSpace 7 End 4 ctrl+a End 5 shift+Left BackSpace 6");
  EXPECT_EQ(saved_z(), "7+346");
}

TEST_F(Typing, GoesNowhereOnceAnotherThingInThePanelIsPressed) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  act("type '+1'");
  act("mousemove 200 590 click 1");  // below all that the panel shows
  const Image before = settled_picture();
  act("type 'sgwCS '");
  settled_picture();
  EXPECT_TRUE(std::filesystem::is_empty(path("err")));
  EXPECT_FALSE(has_written_picture());
  EXPECT_FALSE(std::filesystem::exists(path("saddle.toml")));
  act("key Escape");  // gives the keyboard to the picture, and takes the message away
  EXPECT_EQ(settled_picture().rgba, before.rgba);
  act("key s");
  EXPECT_TRUE(eventually([&] { return has_written_picture(); }));
}

TEST_F(Typing, EscapeClosesHelpAndNeverTheWindow) {
  open({"z=u*v"});
  const Image before = settled_picture();
  enter_field(kFieldOfZ);
  act("type '+0'");
  act("key F1");
  ASSERT_TRUE(eventually([&] { return picture().rgba != before.rgba; })) << "no help";
  act("key Escape");
  EXPECT_TRUE(eventually([&] { return picture().rgba == before.rgba; })) << "help stays";
  act("type '+1'");
  EXPECT_EQ(saved_z(), "u*v+0+1") << "the first Escape leaves the field alone";
  act("key Escape Escape Escape");
  EXPECT_EQ(saved_z(), "u*v+0+1") << "the window stays";
}

TEST_F(Typing, CtrlQQuitsFromAField) {
  open({"z=u*v"});
  enter_field(kFieldOfZ);
  act("type 'q'");
  act("key ctrl+q");
  EXPECT_EQ(status(), 0);
}

/// The viewer in this process, which gets real keys from the display.
class TypingHere : public ViewerHere {
 protected:
  /// Feeds words to xdotool and lets the viewer do what they ask for until something is so; false
  /// if that takes too long or the viewer ends.
  bool act_on(Viewer& viewer, const std::string& words, const std::function<bool()>& is_so) const {
    const std::jthread hand([&] { act(words); });
    const std::jthread waker([](const std::stop_token& end) {
      while (!end.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        Window::wake();
      }
    });
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!viewer.is_to_end() && std::chrono::steady_clock::now() < end) {
      if (is_so() && viewer.is_at_rest()) return true;
      viewer.step();
    }
    return false;
  }
};

ViewerSetup coarse_plane() {
  ViewerSetup setup;
  setup.scene.surfaces.emplace_back().z = "u*v";
  setup.scene.picture.width = 300;
  setup.scene.picture.height = 300;
  setup.tessellate = [](const Scene& scene, std::size_t surface, Detail) {
    Scene asked = scene;
    asked.mesh.samples = GridSize{8, 8};
    return tessellate(asked, asked.surfaces[surface], {.picture = true}, 1);
  };
  return setup;
}

/// Each formula of the gallery once.
std::set<std::string> gallery_formulas() {
  std::set<std::string> formulas;
  for (const GalleryEntry& entry : gallery()) {
    for (const SurfaceSpec& spec : gallery_scene(entry).surfaces) {
      formulas.insert({spec.x, spec.y, spec.z});
    }
  }
  return formulas;
}

/// A key as GLFW numbers it, at a place in the panel.
Event key_event(Event::Kind kind, int code, int mods) {
  Event event;
  event.kind = kind;
  event.place = kFieldOfX;
  event.code = code;
  event.mods = mods;
  return event;
}

TEST_F(TypingHere, SelectsAllThoughCtrlIsLetGoFirstAndAtOnce) {
  constexpr int kA = 65;
  constexpr int kControl = 341;
  constexpr int kModControl = 2;
  Viewer viewer(coarse_plane());
  ASSERT_TRUE(act_on(viewer, "mousemove 200 65", [] { return true; }));
  for (const auto kind : {Event::Kind::Move, Event::Kind::Press, Event::Kind::Release}) {
    viewer.receive(key_event(kind, 0, 0));
  }
  while (viewer.has_events()) viewer.step();
  viewer.receive(key_event(Event::Kind::KeyDown, kControl, 0));
  viewer.receive(key_event(Event::Kind::KeyDown, kA, kModControl));
  viewer.receive(key_event(Event::Kind::KeyUp, kControl, kModControl));
  viewer.receive(key_event(Event::Kind::KeyUp, kA, 0));
  viewer.receive(key_event(Event::Kind::Character, '2', 0));
  while (viewer.has_events()) viewer.step();
  EXPECT_EQ(viewer.model().scene().surfaces[0].x, "2");
}

TEST_F(TypingHere, FillsAFieldWithAnyFormulaOfTheGallery) {
  Viewer viewer(coarse_plane());
  const auto has = [&](const std::string& text) {
    return [&viewer, text] { return viewer.model().scene().surfaces[0].x == text; };
  };
  const auto field = [&] { return viewer.model().scene().surfaces[0].x; };
  ASSERT_TRUE(act_on(viewer, "mousemove 200 65 click 1 type 0", has("u0")));
  int number = 0;
  for (const std::string& formula : gallery_formulas()) {
    // It is undefined everywhere as far as the first sum, which a message says.
    const std::string text = "sqrt(u-9)+" + formula;
    std::vector<std::string> delays{"0"};
    if (number++ % 8 == 0) delays.emplace_back("30");
    for (const std::string& delay : delays) {
      const std::string words = " key ctrl+a type --delay " + delay + " '" + text + "'";
      const std::string confirm = number % 3 == 0 ? "key Return" : "";
      ASSERT_TRUE(act_on(viewer, confirm + words, has(text)))
          << text << " became " << field() << " with a delay of " << delay;
    }
  }
  EXPECT_GT(number, 100);
  std::vector<std::string> files;
  for (const auto& file : std::filesystem::directory_iterator(folder_)) {
    files.push_back(file.path().filename());
  }
  std::erase_if(files, [](const std::string& name) {
    return !name.ends_with(".png") && !name.ends_with(".toml");
  });
  EXPECT_TRUE(files.empty()) << files.front();
}

}  // namespace
}  // namespace saddle
