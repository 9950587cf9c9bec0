// Lists of the window: actions, the gallery, files to open and to write.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/file.h"
#include "export/page/page.h"
#include "scene/model/gallery.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

TEST_F(Workplace, FindsActionsByTheirNames) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-P", "grid li");
  EXPECT_FALSE(viewer.model().view().grid);
  choose(viewer, "Ctrl-P", "undo a");
  EXPECT_TRUE(viewer.model().view().grid);
  choose(viewer, "Ctrl-P", "undo a");
  EXPECT_TRUE(viewer.model().view().grid) << "there is nothing left to undo";
  key(viewer, "Escape", kEscape);
  type(viewer, "g");
  EXPECT_FALSE(viewer.model().view().grid) << "letters are keys again";
}

TEST_F(Workplace, KeepsListsInANarrowWindow) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.width = 40;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  key(viewer, "Ctrl-P");
  ASSERT_TRUE(rests(viewer));
  const Image screen = screenshot();
  constexpr int kBlack = 10;
  EXPECT_LT(screen.pixel(360 - 5, 200)[0], kBlack) << "the picture is at the right of the list";
  EXPECT_GT(screen.pixel(360 - 25, 200)[0], kBlack);
}

TEST_F(Workplace, SearchesTheGalleryAnewEachTime) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-G", "boy");
  EXPECT_EQ(viewer.model().scene().title, "boy");
  choose(viewer, "Ctrl-G", "klein-b");
  EXPECT_EQ(viewer.model().scene().title, "klein-bottle");
  EXPECT_TRUE(rests(viewer));
  key(viewer, "Ctrl-Z");
  key(viewer, "Ctrl-Z");
  EXPECT_EQ(viewer.model().scene().title, "torus");
}

TEST_F(Workplace, OpensFilesByListAndByDrop) {
  write("a.toml", "title = \"first\"\n[[surface]]\nz = \"u\"\n");
  write("b.toml", "title = \"second\"\n[[surface]]\nz = \"v\"\n");
  write("c.toml", "title = \n");
  write("d.png", std::string("\x89PNG\r\n\x1A\n\0\0\0\xFF", 12));
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-O", "a.t");
  EXPECT_EQ(viewer.model().scene().title, "first");
  drop(viewer, path("b.toml"));
  EXPECT_EQ(viewer.model().scene().title, "second");
  for (const std::string& bad :
       {path("c.toml").string(), path("d.png").string(), path("none").string(), std::string("/"),
        std::string("/dev/zero")}) {
    drop(viewer, bad);
    EXPECT_NE(viewer.message(), "") << bad;
    EXPECT_EQ(viewer.model().scene().title, "second") << bad;
  }
  write("b.toml", "title = \"third\"\n[[surface]]\nz = \"v\"\n");
  type(viewer, "r");
  EXPECT_EQ(viewer.model().scene().title, "third") << "reloaded from where it came from";
  EXPECT_EQ(Session().recent_files(), (std::vector{path("b.toml"), path("a.toml")}));
}

TEST_F(Workplace, WritesFilesOfAnyFormat) {
  open({"torus"});
  act("mousemove 700 300 key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("torus.toml")); }));
  const auto take = [&](const std::string& typed, const std::string& name) {
    act("key ctrl+e type '" + typed + "'");
    act("key Return");
    return eventually([&] { return std::filesystem::exists(path(name)); });
  };
  const auto is_same = [&](const std::string& name, std::vector<std::string> options) {
    std::vector<std::string> arguments{path("torus.toml"), "-o", path("other-" + name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    EXPECT_EQ(headless(arguments), 0);
    return read_file(path(name)) == read_file(path("other-" + name));
  };
  ASSERT_TRUE(take("a.ply", "a.ply"));
  EXPECT_TRUE(is_same("a.ply", {}));
  ASSERT_TRUE(take("b.png 64x48", "b.png"));
  EXPECT_TRUE(is_same("b.png", {"--size", "64x48"}));
  ASSERT_TRUE(take("gl", "gl.png")) << "the first of its names";
}

TEST_F(Workplace, ListsTheFormatsWhereAnEndingIsNone) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-E", "a.xyz");
  ASSERT_TRUE(rests(viewer));
  EXPECT_FALSE(std::filesystem::exists(path("a.png"))) << "nothing is written unasked";
  key(viewer, "", kDown);
  key(viewer, "Return", kReturn);
  EXPECT_TRUE(until(viewer, [&] { return std::filesystem::exists(path("a.png")); }));
}

TEST_F(Workplace, GoesOnWhileAPictureIsSaved) {
  write("slow", "#!/bin/sh\ncat >/dev/null\nuntil [ -e go ]; do sleep 0.01; done\ntouch \"$3\"\n");
  std::filesystem::permissions(path("slow"), std::filesystem::perms::owner_all);
  ViewerSetup setup = setup_of(entry("torus"));
  setup.program = path("slow");
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  type(viewer, "s");
  type(viewer, "g");
  EXPECT_FALSE(viewer.model().view().grid);
  ASSERT_TRUE(until(viewer, [&] { return viewer.drawing().is_at_rest(); }));
  EXPECT_FALSE(std::filesystem::exists("torus.png"));
  write("go", "");
  ASSERT_TRUE(until(viewer, [&] { return viewer.message() == "wrote torus.png"; }))
      << viewer.message();
  EXPECT_TRUE(std::filesystem::exists("torus.png"));
}

TEST_F(Workplace, SavesAPageOfWhatItShows) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  choose(viewer, "Ctrl-P", "save page");
  ASSERT_TRUE(until(viewer, [&] { return std::filesystem::exists("torus.html"); }));
  const std::string page = read_file("torus.html");
  EXPECT_NE(page.find("default-src 'none'"), std::string::npos);
  const auto scene = scene_in_page(page, "torus.html");
  ASSERT_TRUE(scene);
  EXPECT_NE(scene->find("r = 0.8"), std::string::npos) << *scene;
  for (int i = 0; i < 2; ++i) choose(viewer, "Ctrl-P", "save page");
  ASSERT_TRUE(until(viewer, [&] { return std::filesystem::exists("torus-3.html"); }));
  EXPECT_EQ(read_file("torus.html"), page) << "nothing is replaced";
}

TEST_F(Workplace, HasTheTitleOfItsScene) {
  open({"torus"});
  EXPECT_EQ(title(), "torus\n");
  act("key ctrl+g type boy");
  act("key Return");
  EXPECT_TRUE(eventually([&] { return title() == "boy\n"; })) << title();
}

}  // namespace
}  // namespace saddle
