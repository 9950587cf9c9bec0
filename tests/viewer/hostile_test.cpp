// Users who mean no good, or cannot know better: nothing ends the window, and nothing is lost.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <utility>

#include "export/formats/load_scene.h"
#include "scene/toml/scene_file.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

constexpr int kTab = 258;
constexpr int kEnd = 269;
constexpr dvec2 kFieldOfZ{200, 115};
constexpr dvec2 kMiddle{570, 200};

class HostileUser : public Workplace {
 protected:
  static std::string scene_of(const Viewer& viewer) { return write_scene(viewer.model().scene()); }
};

TEST_F(HostileUser, TypesGarbageFromFieldToFieldAndUndoesIt) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const std::string first = scene_of(viewer);
  for (const std::string garbage : {"]]]{{%s%n", "1e999999"}) {
    press_at(viewer, kFieldOfZ);
    constexpr int kFields = 14;
    for (int field = 0; field < kFields; ++field) {
      key(viewer, "Ctrl-A");
      type(viewer, garbage);
      key(viewer, "Tab", kTab);
      ASSERT_TRUE(rests(viewer)) << garbage;
    }
    EXPECT_NE(scene_of(viewer), first) << garbage;
    press_at(viewer, kMiddle);
    for (int i = 0; i < 200; ++i) key(viewer, "Ctrl-Z");
    ASSERT_TRUE(rests(viewer)) << garbage;
    EXPECT_EQ(scene_of(viewer), first) << garbage;
    EXPECT_FALSE(viewer.model().error()) << garbage;
  }
}

TEST_F(HostileUser, TypesANameWithoutAnEnd) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, kFieldOfZ);
  key(viewer, "", kEnd);
  type(viewer, "+" + std::string(4000, 'q'));
  ASSERT_TRUE(until(viewer, [&] { return viewer.model().error().has_value(); }));
  ASSERT_TRUE(rests(viewer));
  type(viewer, "q");
  EXPECT_TRUE(rests(viewer));
}

TEST_F(HostileUser, HasAFormulaOfAMegabyte) {
  Scene scene = entry("torus");
  scene.surfaces[0].z = std::string(1'000'000, 'q');
  Viewer viewer(setup_of(std::move(scene)));
  ASSERT_TRUE(until(viewer, [&] { return viewer.model().error().has_value(); }));
  press_at(viewer, kFieldOfZ);  // all of it stands below
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, kMiddle);
  Event event;
  event.place = kFieldOfZ;  // its tip
  viewer.receive(event);
  EXPECT_TRUE(rests(viewer));
  EXPECT_EQ(viewer.model().scene().surfaces[0].z.size(), 1'000'000U);
}

TEST_F(HostileUser, OpensFilesThatAreNone) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const std::string first = scene_of(viewer);
  write("empty.toml", "");
  write("noise.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(2000, '\xff'));
  write("letters.toml", std::string(100'000, '['));
  constexpr std::uintmax_t kHuge = std::uintmax_t{4} << 30;
  for (const char* name : {"huge.toml", "huge.png", "huge"}) {
    write(name, "x");
    std::filesystem::resize_file(path(name), kHuge);
  }
  std::filesystem::create_directory(path("folder.toml"));
  for (const char* name : {"empty.toml", "noise.png", "letters.toml", "huge.toml", "huge.png",
                           "huge", "folder.toml", "none.toml"}) {
    drop(viewer, path(name).string());
    EXPECT_NE(viewer.message(), "") << name;
    EXPECT_EQ(viewer.message().find("saddle "), std::string::npos) << "no command: " << name;
    EXPECT_EQ(viewer.message().find("saddle:"), std::string::npos) << name;
    ASSERT_TRUE(rests(viewer)) << name;
    EXPECT_EQ(scene_of(viewer), first) << name;
  }
  drop(viewer, "/dev/zero");
  EXPECT_NE(viewer.message(), "");
  EXPECT_EQ(scene_of(viewer), first);
  EXPECT_TRUE(until(viewer, [&] { return viewer.message().empty(); })) << "it goes by itself";
}

TEST_F(HostileUser, RemovesTheFileOfAScene) {
  const std::filesystem::path file = path("a.toml");
  write("a.toml", "title = \"first\"\n[[surface]]\nz = \"u\"\n");
  ViewerSetup setup = setup_of(load_scene(file));
  setup.file = setup.watched = file;
  setup.reload = [file] { return load_scene(file); };
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  const auto is_told = [&] { return viewer.message().find("any more") != std::string::npos; };
  std::filesystem::remove(file);
  ASSERT_TRUE(until(viewer, is_told));
  EXPECT_FALSE(viewer.model().error()) << "nothing is wrong with the scene";
  EXPECT_EQ(viewer.message().find("saddle list"), std::string::npos);
  EXPECT_TRUE(until(viewer, [&] { return viewer.message().empty(); })) << "it goes by itself";
  type(viewer, "r");
  EXPECT_TRUE(is_told());
  EXPECT_EQ(viewer.model().scene().title, "first");
  write("a.toml", "title = \"second\"\n[[surface]]\nz = \"v\"\n");
  EXPECT_TRUE(until(viewer, [&] { return viewer.model().scene().title == "second"; }));
  std::filesystem::remove(file);
  std::filesystem::create_directory(file);
  EXPECT_TRUE(until(viewer, [&] { return viewer.message().find("cannot") == 0; }));
  EXPECT_FALSE(viewer.model().error());
}

TEST_F(HostileUser, GivesObjectsLongNames) {
  const auto buttons_of = [&](const std::string& name) {
    Scene scene = entry("torus");
    scene.surfaces[0].name = name;
    scene.definitions.push_back({.name = name, .text = "1"});
    Viewer viewer(setup_of(std::move(scene)));
    EXPECT_TRUE(rests(viewer));
    const Image all = screenshot();
    std::string buttons;
    for (int y = 30; y < 300; ++y) {
      if (y > 50 && y < 270) continue;  // the row of the surface, and that of the definition
      for (int x = 245; x < 300; ++x) buttons += static_cast<char>(all.pixel(x, y)[0]);
    }
    return buttons;
  };
  EXPECT_EQ(buttons_of("a"), buttons_of("a" + std::string(200, 'b')));
}

TEST_F(HostileUser, HoldsKeysDown) {
  open({"z=u*v"});
  act("mousemove 700 300 keydown s sleep 1.5 keyup s");
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  EXPECT_TRUE(std::filesystem::exists(path("saddle.png")));
  EXPECT_FALSE(std::filesystem::exists(path("saddle-2.png"))) << "once is enough";
  open({"z=u*v"});
  enter_field(2);
  act("type +");
  act("keydown 1 sleep 1.5 keyup 1");
  act("mousemove 700 300 click 1 key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  EXPECT_GT(load_scene(path("saddle.toml")).surfaces.at(0).z.size(), 8U) << "letters repeat";
}

TEST_F(HostileUser, MakesTheWindowSmallAndLargeInARush) {
  open({"torus"});
  const auto resize = [&](int width, int height) {
    act("search --onlyvisible --name torus windowsize " + std::to_string(width) + " " +
        std::to_string(height));
  };
  for (int i = 0; i < 40; ++i) resize(1 + 37 * (i % 27), 1 + 53 * (i % 13));
  resize(200, 150);
  settled_picture();
  act("key g");
  resize(900, 600);
  EXPECT_GT(yellow_pixels(settled_picture()), 1000);
  act("key ctrl+q");
  EXPECT_EQ(status(), 0);
}

}  // namespace
}  // namespace saddle
