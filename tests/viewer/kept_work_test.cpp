// Work is not lost: windows that close, displays that go, disks that are full.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "base/file.h"
#include "export/formats/load_scene.h"
#include "scene/toml/scene_file.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

/// While it lives, nothing can be written into the current folder, nor is there one for work.
class NoPlace {
 public:
  explicit NoPlace(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / "gone");
    std::filesystem::current_path(folder / "gone");
    std::filesystem::remove(folder / "gone");
    std::filesystem::create_directories(state_.parent_path());
    std::ofstream(state_) << "no folder";
  }
  ~NoPlace() {
    std::filesystem::current_path(state_.parent_path());
    std::filesystem::remove(state_);
  }
  NoPlace(const NoPlace&) = delete;
  NoPlace& operator=(const NoPlace&) = delete;

 private:
  std::filesystem::path state_ = state_directory();
};

TEST_F(Workplace, BringsUnsavedWorkBack) {
  leave_work("+7");
  Viewer viewer(setup_of(entry("torus")));
  EXPECT_EQ(work_brought_back(viewer), "u*v+7");
  EXPECT_FALSE(Session().left_work());
}

TEST_F(Workplace, BringsWorkWithAMistakeBack) {
  leave_work("+sqrt(kk");
  Viewer viewer(setup_of(entry("torus")));
  EXPECT_EQ(work_brought_back(viewer), "u*v+sqrt(kk");
  EXPECT_TRUE(rests(viewer));
  EXPECT_TRUE(viewer.model().error());
}

TEST_F(Workplace, KeepsNoWorkThatIsSaved) {
  open({"z=u*v"});
  enter_field(2);
  act("type '+7'");
  click(700, 550);
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  EXPECT_FALSE(Session().left_work());
}

TEST_F(Workplace, KeepsWorkThatIsSavedWithAMistake) {
  open({"z=u*v"});
  enter_field(2);
  act("type '+sqrt(kk'");
  click(700, 550);
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  Viewer viewer(setup_of(entry("torus")));
  EXPECT_EQ(work_brought_back(viewer), "u*v+sqrt(kk") << "no window could open the file";
}

TEST_F(Workplace, KeepsWorkOfTheLastMomentWhereTheDisplayGoes) {
  open({"z=u*v"});
  enter_field(2);
  const Image before = screenshot();
  act("type '+7'");
  ASSERT_TRUE(eventually([&] { return screenshot().rgba != before.rgba; }));
  end_display();  // before a second has passed
  EXPECT_EQ(status(), 1);
  EXPECT_NE(standard_error().find("the display has gone"), std::string::npos) << standard_error();
  const auto work = Session().left_work();
  ASSERT_TRUE(work);
  EXPECT_NE(read_file(*work).find("u*v+"), std::string::npos) << read_file(*work);
}

TEST_F(Workplace, TellsOfAPlaceThatTakesNoFileAndLosesNoWork) {
  write("a.toml", "[[surface]]\nz = \"u\"\n");
  Viewer viewer(setup_of(load_scene(path("a.toml"))));
  ASSERT_TRUE(rests(viewer));
  const auto has_left = [] {
    return std::filesystem::is_directory(state_directory()) &&
           !std::filesystem::is_empty(state_directory());
  };
  {
    const NoPlace none(folder_);
    for (const char* save : {"s", "S"}) {
      type(viewer, save);
      ASSERT_TRUE(
          until(viewer, [&] { return viewer.message().find("annot") != std::string::npos; }))
          << save << viewer.message();
      key(viewer, "Escape", kEscape);
      EXPECT_EQ(viewer.message(), "");
    }
    type(viewer, "f");
    ASSERT_TRUE(until(viewer, [&] { return viewer.message().starts_with("unsaved work is not"); }));
    EXPECT_FALSE(has_left());
    type(viewer, "g");
    EXPECT_FALSE(viewer.model().view().grid) << "a message takes no keys";
    key(viewer, "Ctrl-Q");
    EXPECT_FALSE(viewer.is_to_end()) << "the first time it is told";
    EXPECT_TRUE(viewer.message().starts_with("unsaved work would be lost")) << viewer.message();
    ASSERT_TRUE(until(viewer, [&] { return viewer.message().empty(); })) << "by itself";
  }
  key(viewer, "Ctrl-Q");
  EXPECT_TRUE(viewer.is_to_end());
  EXPECT_TRUE(has_left()) << "there is a place again";
}

/// While it lives, no file takes a byte of this process or its children.
class FullDisk {
 public:
  FullDisk() : before_(signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(RLIMIT_FSIZE, &limit_);
    const rlimit none{0, limit_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &none);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &limit_);
    signal(SIGXFSZ, before_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit limit_{};
  void (*before_)(int);
};

std::set<std::string> files_below(const std::filesystem::path& folder) {
  std::set<std::string> files;
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.is_regular_file()) files.insert(file.path());
  }
  return files;
}

TEST_F(Workplace, TellsOfAFullDiskAndLeavesNoHalfOfAFile) {
  write("a.toml", "[[surface]]\nz = \"u\"\n");
  Viewer viewer(setup_of(load_scene(path("a.toml"))));
  ASSERT_TRUE(rests(viewer));
  const auto before = files_below(folder_);
  const auto tells = [&](const std::string& what) {
    return until(viewer, [&] { return viewer.message().find(what) != std::string::npos; });
  };
  {
    const FullDisk full;
    type(viewer, "s");
    ASSERT_TRUE(tells("saddle.png: File too large")) << viewer.message();
    type(viewer, "S");
    ASSERT_TRUE(tells("saddle.toml: File too large")) << viewer.message();
    choose(viewer, "Ctrl-E", "b.ply");
    ASSERT_TRUE(tells("b.ply: File too large")) << viewer.message();
    key(viewer, "Escape", kEscape);
    type(viewer, "f");
    ASSERT_TRUE(tells("unsaved work is not kept")) << viewer.message();
    EXPECT_EQ(files_below(folder_), before);
  }
  type(viewer, "S");
  EXPECT_TRUE(tells("saved saddle.toml")) << viewer.message();
}

TEST_F(Workplace, StandsGarbageWhereverItIsTyped) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const std::string first = write_scene(viewer.model().scene());
  for (int y = 65; y < 390; y += 25) {  // fields, buttons, headers, which open
    press_at(viewer, {200, double(y)});
    type(viewer, "]\"1e999\xC3\xA4,");
  }
  EXPECT_TRUE(rests(viewer)) << "it is there still";
  press_at(viewer, {600, 200});
  while (viewer.model().history().has_past()) key(viewer, "Ctrl-Z");
  EXPECT_EQ(write_scene(viewer.model().scene()), first);
  EXPECT_TRUE(rests(viewer));
  EXPECT_FALSE(viewer.model().error());
}

}  // namespace
}  // namespace saddle
