// The viewer as a hand finds it, under a display without a screen.
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/image_compare.h"
#include "base/image_png.h"
#include "base/random.h"
#include "export/formats/load_scene.h"
#include "viewer/display.h"

namespace saddle {
namespace {

/// Seen straight from above, orthographic: 300 pixels are one unit, (400, 300) is the origin.
const std::vector<std::string> kMap{"--ortho", "--view", "0,0,1", "--up",       "0,1,0", "--target",
                                    "0,0,0",   "--fov",  "90",    "--distance", "1"};

std::vector<std::string> with(std::vector<std::string> words,
                              const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool differ(const Image& a, const Image& b) {
  return a.rgba != b.rgba;
}

TEST_F(ViewerTest, ShowsASurfaceAndEndsWithCtrlQ) {
  open({"torus"});
  EXPECT_GT(yellow_pixels(picture()), 50'000);
  act("key ctrl+q");
  EXPECT_EQ(status(), 0);
}

TEST_F(ViewerTest, TurnsUnderTheHandAndBackAgain) {
  open({"torus"});
  const Image before = settled_picture();
  drag(1, 400, 300, 500, 380);
  EXPECT_TRUE(differ(settled_picture(), before));
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("torus.toml")); }));
  const Scene scene = load_scene(path("torus.toml"));
  EXPECT_GT(degrees_between(scene.camera.view, Camera{}.view), 10);
  EXPECT_TRUE(scene.camera.distance) << "fitted anew, it would grow and shrink under the hand";
}

TEST_F(ViewerTest, TakesGridLinesAwayAndBringsThemBack) {
  open({"torus"});
  const Image before = settled_picture();
  act("key g");
  const Image without = settled_picture();
  EXPECT_TRUE(differ(without, before));
  ASSERT_EQ(headless({"torus", "--grid", "off", "-o", "plain.png"}), 0);
  EXPECT_LT(compare_images(without, read_png(path("plain.png")).image).error, 0.01);
  act("key g");
  EXPECT_FALSE(differ(settled_picture(), before));
}

TEST_F(ViewerTest, ShadesCornersPixelsOrByTheFormula) {
  const std::vector<std::string> coarse{"torus", "--samples", "12x12", "--grid", "off"};
  open(coarse);
  const Image pixels = settled_picture();
  for (const auto& [key, shading] : {std::array{"1", "vertex"}, {"3", "exact"}, {"2", "pixel"}}) {
    act(std::string("key ") + key);
    const Image shown = settled_picture();
    EXPECT_EQ(differ(shown, pixels), shading != std::string("pixel")) << shading;
    ASSERT_EQ(headless(with(coarse, {"--shading", shading, "-o", "a.png"})), 0);
    EXPECT_LT(compare_images(shown, read_png(path("a.png")).image).error, 0.002) << shading;
  }
}

TEST_F(ViewerTest, ZoomsTowardThePointer) {
  open(with({"z=0*u", "u=-1:1", "v=-1:1"}, kMap));
  act("mousemove " + std::to_string(kPanelWidth + 550) +
      " 150 click 4 click 4 click 4");  // at u 0.5, v 0.5
  settled_picture();
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  const Camera camera = load_scene(path("saddle.toml")).camera;
  ASSERT_TRUE(camera.distance && camera.target);
  const double factor = *camera.distance;
  EXPECT_LT(factor, 0.8);
  // The point under the pointer stays: target + (its offset) * factor.
  const dvec3 target = *camera.target;
  EXPECT_NEAR(target.x + 0.5 * factor, 0.5, 1.0 / 300);
  EXPECT_NEAR(target.y + 0.5 * factor, 0.5, 1.0 / 300);
}

TEST_F(ViewerTest, MovesWithTheRightButton) {
  open(with({"z=0*u", "u=-1:1", "v=-1:1"}, kMap));
  drag(3, 300, 300, 360, 330);
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  const Camera camera = load_scene(path("saddle.toml")).camera;
  ASSERT_TRUE(camera.target);
  const dvec3 target = *camera.target;
  EXPECT_NEAR(target.x, -0.2, 1.0 / 300);
  EXPECT_NEAR(target.y, 0.1, 1.0 / 300);
}

TEST_F(ViewerTest, TellsThePointThatIsPicked) {
  open(with({"z=u*v", "u=-1:1", "v=-1:1"}, kMap));
  click(550, 240, "--repeat 2 --delay 50");
  ASSERT_TRUE(eventually([&] { return !standard_output().empty(); }));
  double u = 0;
  double v = 0;
  double x = 0;
  double y = 0;
  double z = 0;
  const std::string line = standard_output();
  ASSERT_EQ(std::sscanf(line.c_str(), "surface: u %lf v %lf x %lf y %lf z %lf", &u, &v, &x, &y, &z),
            5)
      << line;
  EXPECT_NEAR(u, 0.5, 1.0 / 300);
  EXPECT_NEAR(v, 0.2, 1.0 / 300);
  EXPECT_NEAR(z, u * v, 1e-8);  // nine digits are printed
}

TEST_F(ViewerTest, KeepsTheLastGoodSurfaceWhileAFormulaIsWrong) {
  open({"torus"});
  const Image before = settled_picture();
  enter_field(2);
  act("type --delay 20 '*foo(v)'");
  const Image wrong = settled_picture();
  EXPECT_FALSE(differ(wrong, before));
  for (int i = 0; i < 7; ++i) act("key BackSpace");
  act("type --delay 20 '*2'");
  EXPECT_TRUE(differ(settled_picture(), before));
  act("key Escape");  // leaves the field: its text is what it was
  act("key ctrl+q");
  EXPECT_EQ(status(), 0);
}

TEST_F(ViewerTest, UndoesAnEdit) {
  open({"torus"});
  const Image before = settled_picture();
  act("key f");
  EXPECT_TRUE(differ(settled_picture(), before));
  act("key ctrl+z");
  EXPECT_FALSE(differ(settled_picture(), before));
  act("key ctrl+y");
  EXPECT_TRUE(differ(settled_picture(), before));
  act("key ctrl+z");
  EXPECT_FALSE(differ(settled_picture(), before));
  act("key ctrl+shift+z");
  EXPECT_TRUE(differ(settled_picture(), before));
}

TEST_F(ViewerTest, PlaysAndStops) {
  open({"z=sin(3*u+5*t)", "u=-1:1", "v=-1:1"});  // no moment is like another
  const Image before = settled_picture();
  // A picture of the same moment may be coarser.
  const auto has_moved = [&](const Image& now) { return compare_images(now, before).error > 0.1; };
  act("key space");
  EXPECT_TRUE(eventually([&] { return has_moved(picture()); }));
  act("key space");
  const Image after = settled_picture();
  EXPECT_TRUE(has_moved(after));
  EXPECT_FALSE(differ(picture(), after));
}

TEST_F(ViewerTest, SavesThePictureThatTheSavedSceneGives) {
  open({"torus"});
  drag(1, 400, 300, 330, 210);
  act("mousemove " + std::to_string(kPanelWidth + 420) + " 300 click 4 click 4");
  const Image shown = settled_picture();
  act("key s");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("torus.png")); }));
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("torus.toml")); }));
  ASSERT_EQ(headless({"torus.toml", "-o", "headless.png"}), 0);
  const Image saved = read_png(path("torus.png")).image;
  EXPECT_EQ(saved.width, 800);
  EXPECT_LT(compare_images(saved, read_png(path("headless.png")).image).error, 0.001);
  EXPECT_LT(compare_images(saved, shown).error, 0.001) << "nor is the window's another";
}

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path) << text;
}

TEST_F(ViewerTest, HoldsAnAnimationThatAnEditHasMadeLarger) {
  write(path("s.toml"),
        "scale = \"equal\"\n[animation]\nt = [0, 1]\n"
        "[[surface]]\nx = \"u\"\ny = \"v\"\nz = \"t*u*v\"\n");
  open({"s.toml"});
  settled_picture();
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  enter_field(2);
  act("type '*20'");
  act("key Tab");  // leaves the field
  click(700, 550);
  settled_picture();
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle-2.toml")); }));
  const auto before = load_scene(path("saddle.toml")).camera.distance;
  const auto after = load_scene(path("saddle-2.toml")).camera.distance;
  ASSERT_TRUE(before && after);
  EXPECT_GT(double(*after), 5 * double(*before));
}

TEST_F(ViewerTest, FollowsTheSceneFile) {
  const std::string ends = "[[surface]]\nz = \"a*u*v\"\n";
  write(path("s.toml"), "[params]\na = 1\n" + ends);
  open({"s.toml", "--watch"});
  drag(1, 400, 300, 450, 330);
  const Image before = settled_picture();
  const Image whole = screenshot();
  write(path("s.toml"), "[params]\na = \n" + ends);
  ASSERT_TRUE(eventually([&] { return differ(screenshot(), whole); })) << "no message";
  const Image broken = settled_picture();
  EXPECT_GT(yellow_pixels(broken), yellow_pixels(before) / 2) << "the last picture stays";
  write(path("s.toml"), "[params]\na = 2\n" + ends);
  ASSERT_TRUE(eventually([&] { return differ(picture(), broken); }));
  settled_picture();
  act("key S");
  ASSERT_TRUE(eventually([&] { return std::filesystem::exists(path("saddle.toml")); }));
  const Scene scene = load_scene(path("saddle.toml"));
  EXPECT_GT(degrees_between(scene.camera.view, Camera{}.view), 5) << "the camera is kept";
  EXPECT_EQ(scene.definitions.at(0).text, "2");
}

TEST_F(ViewerTest, KeepsThePictureWhereTheSceneFileHasANumberThatIsTooLong) {
  write(path("s.toml"), "[[surface]]\nz = \"u*v\"\n");
  open({"s.toml", "--watch"});
  const Image before = settled_picture();
  const Image whole = screenshot();
  write(path("s.toml"), "[[surface]]\nz = 9007199254740993\n");
  ASSERT_TRUE(eventually([&] { return differ(screenshot(), whole); })) << "no message";
  EXPECT_GT(yellow_pixels(settled_picture()), yellow_pixels(before) / 2)
      << "the last picture stays";
}

TEST_F(ViewerTest, DrawsNothingWhileNothingHappens) {
  open({"torus", "-v"});
  act("key ctrl+q");
  ASSERT_EQ(status(), 0);
  int pictures = 0;
  int frames = 0;
  const std::string said = standard_error();
  ASSERT_EQ(std::sscanf(said.c_str(), "viewer: %d pictures, %d frames", &pictures, &frames), 2)
      << said;
  EXPECT_LE(pictures, 5) << "nothing, preview, mesh; and a finer one of it";
  EXPECT_LE(frames, 20) << "waiting for the picture to settle takes a second";
}

TEST_F(ViewerTest, SaysTheWayOutWhereNoWindowCanBe) {
  const auto fails = [&](const std::string& on) {
    EXPECT_EQ(run({"torus"}, on), 1);
    EXPECT_NE(standard_error().find("-o FILE.png"), std::string::npos) << standard_error();
  };
  fails("");      // no display
  fails(":999");  // one that is not there
  setenv("LIBGL_DRIVERS_PATH", "/nowhere", 1);
  fails(display());  // no driver
  unsetenv("LIBGL_DRIVERS_PATH");
  setenv("MESA_GL_VERSION_OVERRIDE", "3.2", 1);
  fails(display());  // an old OpenGL
  unsetenv("MESA_GL_VERSION_OVERRIDE");
}

TEST_F(ViewerTest, RefusesOptionsThatItWouldIgnore) {
  for (const std::string option : {"--strict", "--renderer=osmesa"}) {
    EXPECT_EQ(run({"torus", option}, display()), 2) << option;
  }
}

TEST_F(ViewerTest, IsTwiceAsLargeWhereDotsAreHalfAsLarge) {
  set_dots_per_inch(192);
  open({"torus", "-s", "300x300"});
  const Image screen = screenshot();
  const auto is_panel = [&](int x) { return screen.pixel(x, 500)[0] > 5; };
  EXPECT_TRUE(is_panel(545)) << "the panel is 558 pixels wide, of a window of 1240";
  EXPECT_FALSE(is_panel(570));
}

TEST_F(ViewerTest, SurvivesAnything) {
  open({"torus"});
  const std::vector<std::string> things{
      "key g",           "key w",      "key n",      "key f",    "key l",
      "key o",           "key x",      "key y",      "key z",    "key Home",
      "key space",       "key t",      "key Tab",    "key F1",   "key r",
      "key bracketleft", "key ctrl+z", "key ctrl+y", "key c",    "key C",
      "click 1",         "click 4",    "click 5",    "click 3",  "click --repeat 2 1",
      "mousedown 1",     "mouseup 1",  "key u",      "key plus", "key parenleft",
      "key BackSpace",   "key ctrl+a", "key slash",  "key 2",    "key Return"};
  auto random_below = [key = std::uint64_t{0}](int end) mutable {
    return static_cast<int>(end * random_unit(key++));
  };
  for (int round = 0; round < 2; ++round) {
    std::string words;
    for (int i = 0; i < 200; ++i) {
      words += "mousemove " + std::to_string(random_below(1080)) + " " +
               std::to_string(random_below(600)) + " " +
               things[random_below(static_cast<int>(things.size()))] + " ";
    }
    act(words);
  }
  act("mouseup 1 mouseup 3 mousemove 700 300 click 1 key ctrl+q");
  EXPECT_EQ(status(), 0) << standard_error();
}

}  // namespace
}  // namespace saddle
