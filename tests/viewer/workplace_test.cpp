// The window as a place to work in: lists, files, the start page, and work that is not lost.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/file.h"
#include "export/formats/load_scene.h"
#include "export/page/page.h"
#include "paths.h"
#include "scene/model/gallery.h"
#include "scene/toml/scene_file.h"
#include "view/window/viewer.h"
#include "viewer/display.h"

namespace saddle {
namespace {

constexpr std::chrono::seconds kPatience{30};

/// GLFW's numbers of keys.
constexpr int kReturn = 257;
constexpr int kEscape = 256;
constexpr int kDown = 264;

/// So many of a picture of 640x360 are no seam.
constexpr int kFewPixels = 20;

int differing_pixels(const Image& a, const Image& b) {
  int count = 0;
  for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
    count += std::equal(&a.rgba[i], &a.rgba[i] + 4, &b.rgba[i]) ? 0 : 1;
  }
  return count;
}

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

/// The viewer in this process, with events that are made up.
class Workplace : public ViewerTest {
 protected:
  void SetUp() override {
    ViewerTest::SetUp();
    if (IsSkipped()) return;
    setenv("DISPLAY", display().c_str(), 1);
    unsetenv("WAYLAND_DISPLAY");
    before_ = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
  }
  void TearDown() override {
    if (!before_.empty()) std::filesystem::current_path(before_);
    ViewerTest::TearDown();
  }

  static ViewerSetup setup_of(Scene scene) {
    ViewerSetup setup;
    setup.scene = std::move(scene);
    setup.scene.picture.width = 500;
    setup.scene.picture.height = 400;
    setup.threads = 1;
    setup.program = program_path();
    return setup;
  }
  static Scene entry(const char* name) { return gallery_scene(*find_gallery_entry(name)); }

  /// Steps until something is so; false if that takes too long.
  static bool until(Viewer& viewer, const std::function<bool()>& is_so) {
    const std::jthread waker([](const std::stop_token& end) {
      while (!end.stop_requested()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        Window::wake();
      }
    });
    const auto end = std::chrono::steady_clock::now() + kPatience;
    while (!is_so()) {
      if (std::chrono::steady_clock::now() > end || viewer.is_to_end()) return false;
      viewer.step();
    }
    return true;
  }
  static bool rests(Viewer& viewer) {
    return until(viewer, [&] { return viewer.is_at_rest(); });
  }

  static void key(Viewer& viewer, const std::string& name, int code = 0) {
    for (const auto kind : {Event::Kind::KeyDown, Event::Kind::KeyUp}) {
      Event event;
      event.kind = kind;
      event.place = {700, 300};
      event.code = code;
      if (kind == Event::Kind::KeyDown) event.key = name;
      viewer.receive(event);
    }
    while (viewer.has_events()) viewer.step();
    viewer.step();
  }
  static void type(Viewer& viewer, const std::string& text) {
    for (const char c : text) {
      Event event;
      event.kind = Event::Kind::Character;
      event.place = {700, 300};
      event.code = c;
      event.key = c;
      viewer.receive(event);
    }
    while (viewer.has_events()) viewer.step();
    viewer.step();
  }
  static void drop(Viewer& viewer, const std::string& file) {
    Event event;
    event.kind = Event::Kind::Drop;
    event.place = {700, 300};
    event.key = file;
    viewer.receive(event);
    while (viewer.has_events()) viewer.step();
  }
  /// Opens a list, types, and takes what is first.
  static void choose(Viewer& viewer, const std::string& list, const std::string& words) {
    key(viewer, list);
    viewer.step();
    type(viewer, words);
    key(viewer, "Return", kReturn);
  }

  static void press_at(Viewer& viewer, const dvec2& place) {
    for (const auto kind : {Event::Kind::Move, Event::Kind::Press, Event::Kind::Release}) {
      Event event;
      event.kind = kind;
      event.place = place;
      viewer.receive(event);
    }
    while (viewer.has_events()) viewer.step();
  }

  /// The formula z of another window's work, which is there now.
  static std::string work_brought_back(Viewer& viewer) {
    EXPECT_TRUE(rests(viewer));
    choose(viewer, "Ctrl-P", "unsaved");
    const Scene& scene = viewer.model().scene();
    return scene.surfaces.size() == 1 ? scene.surfaces[0].z : "nothing";
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
  }

 private:
  std::filesystem::path before_;
};

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

TEST_F(Workplace, BeginsWithThePicturesOfTheGallery) {
  ViewerSetup setup = setup_of({});
  setup.start = true;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  key(viewer, "", kDown);
  key(viewer, "Return", kReturn);
  ASSERT_TRUE(until(viewer, [&] { return !viewer.model().scene().surfaces.empty(); }));
  EXPECT_TRUE(rests(viewer));
  const std::string chosen = viewer.model().scene().title;
  EXPECT_NE(chosen, gallery()[0].name) << "an arrow has gone to the next row";
  EXPECT_NE(find_gallery_entry(chosen), nullptr);
}

TEST_F(Workplace, BringsUnsavedWorkBack) {
  open({"z=u*v"});
  enter_field(2);
  act("type '+7'");
  settled_picture();
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  Viewer viewer(setup_of(entry("torus")));
  EXPECT_EQ(work_brought_back(viewer), "u*v+7");
  EXPECT_FALSE(Session().left_work());
}

TEST_F(Workplace, BringsWorkWithAMistakeBack) {
  open({"z=u*v"});
  enter_field(2);
  act("type '+sqrt(kk'");
  settled_picture();
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  Viewer viewer(setup_of(entry("torus")));
  EXPECT_EQ(work_brought_back(viewer), "u*v+sqrt(kk");
  EXPECT_TRUE(rests(viewer));
  EXPECT_TRUE(viewer.model().error());
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

TEST_F(Workplace, WritesFilesOfAnyFormat) {
  open({"torus"});
  act("mousemove 700 300 key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("torus.toml")); }));
  const auto take = [&](const std::string& typed, const std::string& name) {
    act("key ctrl+e sleep 0.5 type '" + typed + "'");
    act("sleep 0.5 key Return");
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

TEST_F(Workplace, KeepsNoWorkThatIsSaved) {
  open({"z=u*v"});
  enter_field(2);
  act("type '+7'");
  settled_picture();
  click(700, 550);
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  EXPECT_FALSE(Session().left_work());
}

TEST_F(Workplace, HasTheTitleOfItsScene) {
  open({"torus"});
  EXPECT_EQ(title(), "torus\n");
  act("key ctrl+g sleep 0.5 type boy");
  act("sleep 0.3 key Return");
  EXPECT_TRUE(eventually([&] { return title() == "boy\n"; })) << title();
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
  Scene scene = load_scene(source_folder() + "/examples/see-through.toml");
  scene.picture.width = 640;
  scene.picture.height = 360;
  ViewerSetup setup;
  setup.scene = scene;
  Viewer viewer(std::move(setup));
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
  Scene scene = load_scene(source_folder() + "/examples/see-through.toml");
  scene.picture.width = 800;
  scene.picture.height = 600;
  ViewerSetup setup;
  setup.scene = scene;
  Viewer viewer(std::move(setup));
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
