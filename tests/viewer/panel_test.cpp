// The panel as a hand finds it: rows, sliders, what it says and marks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "scene/toml/scene_file.h"
#include "viewer/workplace.h"

namespace saddle {
namespace {

/// Rows of a scene of one surface with two parameters, as the torus: their middles.
constexpr double kRowOfSurface = 40;
constexpr double kFieldOfZ = 115;
constexpr double kRowOfParameter = 231;
constexpr double kLights = 306;
constexpr double kNodes = 331;
/// The next row.
constexpr double kApart = 25;

constexpr dvec2 kEye{45, kRowOfSurface};
constexpr int kHome = 268;  // GLFW's
constexpr int kEnd = 269;

class PanelRows : public Workplace {
 protected:
  static void press_row(Viewer& viewer, double y) { press_at(viewer, {100, y}); }

  /// Types a definition below the torus's two. The panel keeps it in its field, without a mistake.
  static void define_in_vain(Viewer& viewer, const char* text) {
    press_row(viewer, kRowOfParameter + 2 * kApart);
    type(viewer, text);
    key(viewer, "Return", kReturn);
    ASSERT_TRUE(rests(viewer));
    EXPECT_EQ(viewer.model().scene().definitions.size(), 2U);
    EXPECT_FALSE(viewer.model().error()) << viewer.model().error()->what();
  }

  static void drag(Viewer& viewer, const dvec2& from, const dvec2& to) {
    const auto send = [&](Event::Kind kind, const dvec2& place) {
      Event event;
      event.kind = kind;
      event.place = place;
      viewer.receive(event);
      settle(viewer);
    };
    send(Event::Kind::Move, from);
    send(Event::Kind::Press, from);
    send(Event::Kind::Move, 0.5 * (from + to));
    send(Event::Kind::Move, to);
    send(Event::Kind::Release, to);
  }
  static void double_click(Viewer& viewer, const dvec2& place) {
    for (int i = 0; i < 2; ++i) press_at(viewer, place);
  }
  /// Where the middle of the picture is, in a window of setup_of().
  static constexpr dvec2 kMiddle{320 + 250, 200};
};

bool is_mark(const Image& screen, const dvec2& place) {
  const auto* const p = screen.pixel(static_cast<int>(place.x), static_cast<int>(place.y));
  return p[0] > 120 && 2 * p[1] < p[0] && 2 * p[2] < p[0];
}

TEST_F(PanelRows, SwitchLightsOneByOneAndAllTogetherIsTold) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kLights);
  const auto lights = [&]() -> const std::vector<Light>& { return viewer.model().scene().lights; };
  ASSERT_EQ(lights().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    press_at(viewer, {45, kLights + kApart * static_cast<double>(i + 1)});
    EXPECT_TRUE(lights()[i].enabled == 0) << i;
  }
  ASSERT_TRUE(rests(viewer));
  const auto& warnings = viewer.drawing().figures().warnings;
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings.back().find("light"), std::string::npos) << warnings.back();
  press_at(viewer, kMiddle);
  key(viewer, "Ctrl-Z");
  EXPECT_TRUE(lights()[2].enabled == 1);
}

TEST_F(PanelRows, OpenByAClickThatComesAtOnce) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.height = 650;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kLights);
  press_row(viewer, kLights + kApart);            // the first light
  press_at(viewer, {200, kLights + 4 * kApart});  // its position, below its frame and kind
  type(viewer, "7");
  const Light& light = viewer.model().scene().lights[0];
  EXPECT_FALSE(light.position.y == default_lights()[0].position.y &&
               light.position.x == default_lights()[0].position.x &&
               light.position.z == default_lights()[0].position.z)
      << "a number of the first light is edited";
}

TEST_F(PanelRows, SoftenTheEdgeOfASpot) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.height = 690;
  Light& light = setup.scene.lights[0];
  light.attenuation.range = Number(50);
  light.spot.emplace().inner = Number(20);
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kLights);
  press_row(viewer, kLights + kApart);  // the first light
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kLights + 13 * kApart);  // its falloff
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kLights + 13 * kApart - 26);  // the last word: the list has no room below
  const auto falloff = [&] { return viewer.model().scene().lights[0].spot->falloff; };
  EXPECT_EQ(falloff(), Spot::Falloff::Smooth);
  press_at(viewer, kMiddle);
  key(viewer, "Ctrl-Z");
  EXPECT_EQ(falloff(), Spot::Falloff::Linear);
}

TEST_F(PanelRows, DragSlidersToRoundValues) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const auto value = [&] { return viewer.model().scene().definitions.at(0).text; };
  ASSERT_EQ(value(), "2");
  drag(viewer, {166, kRowOfParameter}, {186, kRowOfParameter});
  EXPECT_GT(std::atof(value().c_str()), 2.5);
  EXPECT_LE(value().size(), 4U) << value() << " is no round number";
  press_at(viewer, kMiddle);
  key(viewer, "Ctrl-Z");
  EXPECT_EQ(value(), "2") << "a drag is one change";
}

TEST_F(PanelRows, BeginTheirFieldsAtOnePlace) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const Image screen = screenshot();
  const auto begin_of_field = [&](int y) {
    int x = 20;  // behind the name
    const auto is_field = [&](const std::uint8_t* p) { return p[2] > p[0] + 20; };
    while (x < 60 && !is_field(screen.pixel(x, y))) ++x;
    return x;
  };
  constexpr int kAboveLetters = -8;
  const int x = begin_of_field(65 + kAboveLetters);
  EXPECT_LT(x, 60);
  for (const double row : {90.0, kFieldOfZ, 140.0, kRowOfParameter, kRowOfParameter + kApart}) {
    EXPECT_EQ(begin_of_field(static_cast<int>(row) + kAboveLetters), x) << "at " << row;
  }
}

TEST_F(PanelRows, ShowWhatHoldsWhereNoWordIsChosen) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.height = 650;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, {20, 186});  // more
  ASSERT_TRUE(rests(viewer));
  const Image screen = screenshot();
  int letters = 0;
  for (int y = 277; y < 291; ++y) {  // the colour map
    for (int x = 82; x < 200; ++x) letters += screen.pixel(x, y)[0] > 100 ? 1 : 0;
  }
  EXPECT_GT(letters, 50);
}

TEST_F(PanelRows, GoBackToTheScenesWordWhereOneWasChosen) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.height = 650;
  setup.scene.surfaces[0].shading = Shading::Vertex;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, {20, 186});  // more
  ASSERT_TRUE(rests(viewer));
  constexpr double kShading = 583;
  press_at(viewer, {200, kShading});
  ASSERT_TRUE(rests(viewer));
  constexpr double kFirstWord = kShading - 101;  // the list has no room below
  press_at(viewer, {200, kFirstWord});
  EXPECT_FALSE(viewer.model().scene().surfaces[0].shading);
  press_at(viewer, kMiddle);
  key(viewer, "Ctrl-Z");
  EXPECT_EQ(viewer.model().scene().surfaces[0].shading, Shading::Vertex);
}

TEST_F(PanelRows, TakeNoDefinitionWithoutAFormula) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  ASSERT_NO_FATAL_FAILURE(define_in_vain(viewer, "foo"));
  type(viewer, "=r");
  key(viewer, "Return", kReturn);
  ASSERT_TRUE(rests(viewer));
  ASSERT_EQ(viewer.model().scene().definitions.size(), 3U);
  EXPECT_EQ(viewer.model().scene().definitions[2].text, "r");
}

TEST_F(PanelRows, TakeNoDefinitionOfAFunctionsName) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  ASSERT_NO_FATAL_FAILURE(define_in_vain(viewer, "sin=2"));
  key(viewer, "", kHome);
  type(viewer, "my");
  key(viewer, "Return", kReturn);
  ASSERT_TRUE(rests(viewer));
  ASSERT_EQ(viewer.model().scene().definitions.size(), 3U);
  EXPECT_EQ(viewer.model().scene().definitions[2].name, "mysin");
}

/// Two surfaces and a curve, all of them with an x, y and z; none is unfolded at first.
Scene three_objects() {
  Scene scene;
  for (const char* const name : {"one", "two"}) {
    SurfaceSpec& spec = scene.surfaces.emplace_back();
    spec.name = name;
    spec.x = "u";
    spec.y = "v";
    spec.z = "u*v";
  }
  CurveSpec& curve = scene.curves.emplace_back();
  curve.name = "curve";
  curve.x = curve.y = curve.z = "s";
  return scene;
}

TEST_F(PanelRows, LeaveButtonsOutWhereNamesHaveNoRoom) {
  const auto setup_in = [&](int window) {
    Scene scene = three_objects();
    scene.surfaces[0].name = "hyperboloid 1";
    scene.surfaces[1].name = "hyperboloid 2";
    scene.surfaces.push_back(scene.surfaces[0]);  // so many that they are folded
    scene.surfaces[2].name = "hyperboloid 3";
    ViewerSetup setup = setup_of(std::move(scene));
    setup.scene.picture.width = window - kPanelWidth;
    return setup;
  };
  constexpr int kNarrow = 330;  // the panel has 148
  constexpr int kWider = 400;   // 180
  const auto has_deleted = [](Viewer& viewer, double x) {
    press_at(viewer, {x, kRowOfSurface + kApart});
    return viewer.model().scene().surfaces.size() == 2;
  };
  {
    Viewer viewer(setup_in(kNarrow));
    ASSERT_TRUE(rests(viewer));
    const Image screen = screenshot();
    const auto row = [&](double middle) {
      std::string letters;
      for (int y = -8; y < 8; ++y) {
        for (int x = 30; x < 126; ++x) {
          letters += screen.pixel(x, static_cast<int>(middle) + y)[0] > 100 ? '#' : ' ';
        }
      }
      return letters;
    };
    EXPECT_GT(std::ranges::count(row(kRowOfSurface), '#'), 40);
    // Both names begin alike, and the second row alone would have a button for one place up.
    EXPECT_EQ(row(kRowOfSurface), row(kRowOfSurface + kApart));
    EXPECT_FALSE(has_deleted(viewer, 114));
  }
  Viewer viewer(setup_in(kWider));
  ASSERT_TRUE(rests(viewer));
  EXPECT_TRUE(has_deleted(viewer, 146));
}

TEST_F(PanelRows, MarkAMistakeInItsOwnObjectAlone) {
  Scene scene = three_objects();
  scene.surfaces[0].z = "nothing";
  ViewerSetup setup = setup_of(std::move(scene));
  setup.scene.picture.height = 650;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(until(viewer, [&] { return viewer.model().error().has_value(); }));
  ASSERT_TRUE(rests(viewer));
  const Image screen = screenshot();
  const auto red_letters = [&](int row) {
    int letters = 0;
    for (int y = row - 8; y < row + 8; ++y) {
      for (int x = 28; x < 120; ++x) letters += screen.pixel(x, y)[0] > screen.pixel(x, y)[2] + 60;
    }
    return letters;
  };
  EXPECT_GT(red_letters(115), 20);
  EXPECT_EQ(red_letters(284), 0) << "the other surface's z";
  EXPECT_EQ(red_letters(478), 0) << "the curve's z";
}

TEST_F(PanelRows, NameTheObjectThatIsUndefined) {
  const auto strip_of = [&](std::size_t faulty) {
    Scene scene = three_objects();
    scene.surfaces[faulty].z = "sqrt(-1-u*u)";
    Viewer viewer(setup_of(std::move(scene)));
    EXPECT_TRUE(until(viewer, [&] { return viewer.model().error().has_value(); }));
    EXPECT_TRUE(rests(viewer));
    EXPECT_EQ(viewer.model().faulty()->name, faulty == 0 ? "one" : "two");
    const Image screen = screenshot();
    std::string strip;
    for (int y = 250; y < 270; ++y) {
      for (int x = 5; x < 100; ++x) strip += static_cast<char>(screen.pixel(x, y)[0]);
    }
    return strip;
  };
  EXPECT_NE(strip_of(0), strip_of(1));
}

TEST_F(PanelRows, TellMistakesOfFilesInTheWordsOfAWindow) {
  const auto strip_of = [&](const Place& place, const Hint& hint) {
    ViewerSetup setup = setup_of(entry("torus"));
    setup.reload = [&]() -> Scene { throw Error(Status::Input, "it is wrong", place, hint); };
    Viewer viewer(std::move(setup));
    EXPECT_TRUE(rests(viewer));
    type(viewer, "r");
    EXPECT_TRUE(rests(viewer));
    const Image screen = screenshot();
    std::string strip;
    for (int y = 255; y < 400; ++y) {
      for (int x = 5; x < 290; ++x) strip += static_cast<char>(screen.pixel(x, y)[0]);
    }
    return strip;
  };
  const std::string plain = strip_of({"z", "z = \"u*\"", {6, 7}}, "add a number");
  EXPECT_EQ(strip_of({"z", "[[surface]]\nz = \"u*\"\nx = 3", {18, 19}}, "add a number"), plain)
      << "the line alone is shown";
  EXPECT_EQ(strip_of({"z", "z = \"u*\"", {6, 7}}, {"add a number", "saddle list names them"}),
            plain)
      << "there are no commands in a window";
  EXPECT_NE(strip_of({"z", "z = \"u*\"", {6, 7}, "a.toml:2:7"}, "add a number"), plain);
}

TEST_F(PanelRows, ShowAPickedPointAlsoWhereTheListIsLong) {
  Viewer viewer(setup_of(three_objects()));
  ASSERT_TRUE(rests(viewer));
  const auto panel = [&] {
    const Image screen = screenshot();
    std::string pixels;
    for (int y = 25; y < 400; ++y) {
      for (int x = 5; x < 290; ++x) pixels += static_cast<char>(screen.pixel(x, y)[0]);
    }
    return pixels;
  };
  const std::string before = panel();
  double_click(viewer, kMiddle);
  ASSERT_TRUE(viewer.model().picked());
  ASSERT_TRUE(rests(viewer));
  EXPECT_NE(panel(), before);
}

TEST_F(PanelRows, MakeASliderForAnUnknownName) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kFieldOfZ);
  key(viewer, "", kEnd);
  type(viewer, "*kk");
  ASSERT_TRUE(until(viewer, [&] { return viewer.model().error().has_value(); }));
  settle(viewer);
  constexpr double kStrip = 400 - 140;  // its first line, with the button
  press_at(viewer, {60, kStrip});
  ASSERT_TRUE(rests(viewer));
  const Scene& scene = viewer.model().scene();
  ASSERT_EQ(scene.definitions.back().name, "kk");
  EXPECT_EQ(scene.sliders.back().name, "kk");
  EXPECT_FALSE(viewer.model().error());
}

TEST_F(PanelRows, RestWhileAFieldHasATextOfItsOwn) {
  ViewerSetup setup = setup_of(entry("torus"));
  setup.scene.picture.height = 650;
  Viewer viewer(std::move(setup));
  ASSERT_TRUE(rests(viewer));
  const auto rests_after = [&](const dvec2& field, const std::string& typed) {
    press_at(viewer, field);
    key(viewer, "", kEnd);
    type(viewer, typed);
    ASSERT_TRUE(rests(viewer)) << typed;
    const std::size_t version = viewer.model().history().version();
    for (int i = 0; i < 3; ++i) press_at(viewer, field);
    EXPECT_EQ(viewer.model().history().version(), version) << typed;
    ASSERT_TRUE(rests(viewer)) << typed;
  };
  constexpr dvec2 kEndOfSlider{232, kRowOfParameter};
  rests_after(kEndOfSlider, "-");  // no number
  rests_after(kEndOfSlider, "5");  // nor is 4-5
  press_at(viewer, kMiddle);
  rests_after(kEndOfSlider, ".0");  // the same number
  press_row(viewer, kLights);
  press_row(viewer, kLights + kApart);             // the first light
  rests_after({200, kLights + 4 * kApart}, ".0");  // its position
}

TEST_F(PanelRows, NameTheSliderWhoseEndsAreWrong) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  press_at(viewer, {100, kRowOfParameter});  // where it begins: 0
  key(viewer, "", kEnd);
  type(viewer, "9");
  ASSERT_TRUE(rests(viewer));
  ASSERT_TRUE(viewer.model().error());
  const Image screen = screenshot();
  constexpr int kBehindTheMessage = 200;  // alone, without a name
  int letters = 0;
  for (int y = 252; y < 268; ++y) {
    for (int x = kBehindTheMessage; x < 300; ++x) {
      const auto* const p = screen.pixel(x, y);
      letters += p[0] > p[2] + 60 ? 1 : 0;
    }
  }
  EXPECT_GT(letters, 20);
}

TEST_F(PanelRows, AddHideAndUndo) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const std::string first = write_scene(viewer.model().scene());
  for (const char* add : {"add surface", "add curve", "add point"}) choose(viewer, "Ctrl-P", add);
  press_at(viewer, kEye);
  ASSERT_TRUE(rests(viewer));
  const Scene& scene = viewer.model().scene();
  EXPECT_FALSE(scene.surfaces.at(0).visible);
  EXPECT_EQ(scene.surfaces.size() + scene.curves.size() + scene.points.size(), 4U);
  press_at(viewer, kMiddle);
  for (int i = 0; i < 4; ++i) key(viewer, "Ctrl-Z");
  EXPECT_EQ(write_scene(viewer.model().scene()), first);
}

TEST_F(PanelRows, AddNodesAndNameThem) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  press_row(viewer, kNodes);
  press_at(viewer, {35, kNodes + kApart - 2});  // + node
  ASSERT_EQ(viewer.model().scene().nodes.size(), 1U);
  press_row(viewer, kNodes + kApart);      // unfolds it
  press_row(viewer, kNodes + 2 * kApart);  // its name
  key(viewer, "", kEnd);
  type(viewer, "s");
  EXPECT_EQ(viewer.model().scene().nodes.at(0).name, "nodes");
  ASSERT_TRUE(rests(viewer));
  EXPECT_FALSE(viewer.model().error());
  press_at(viewer, kMiddle);
  key(viewer, "Ctrl-Z");
  key(viewer, "Ctrl-Z");
  EXPECT_TRUE(viewer.model().scene().nodes.empty());
}

TEST_F(PanelRows, StayBesideLongMessages) {
  Viewer viewer(setup_of(entry("torus")));
  ASSERT_TRUE(rests(viewer));
  const Image before = screenshot();
  drop(viewer, "/" + std::string(200, 'n') + "/" + std::string(200, 'm'));
  ASSERT_NE(viewer.message(), "");
  settle(viewer);
  const Image after = screenshot();
  int in_panel = 0;
  int in_picture = 0;
  int at_rim = 0;
  for (int y = 0; y < 400; ++y) {
    for (int x = 0; x < 820; ++x) {
      const bool is_same =
          std::equal(before.pixel(x, y), before.pixel(x, y) + 4, after.pixel(x, y));
      if (is_same) continue;
      ++(x < kPanelWidth ? in_panel : in_picture);
      if (y > 395 || x > 815) ++at_rim;
    }
  }
  EXPECT_EQ(in_panel, 0);
  EXPECT_GT(in_picture, 1000);
  EXPECT_EQ(at_rim, 0) << "all of it is in the window";
}

TEST_F(PanelRows, MarkAPickedPointHollowWhereItIsHidden) {
  Viewer viewer(setup_of(entry("sphere")));
  ASSERT_TRUE(rests(viewer));
  type(viewer, "x");
  ASSERT_TRUE(rests(viewer));
  double_click(viewer, kMiddle);
  ASSERT_TRUE(viewer.model().picked());
  ASSERT_TRUE(rests(viewer));
  EXPECT_TRUE(is_mark(screenshot(), kMiddle));
  type(viewer, "x");  // from the other side
  ASSERT_TRUE(rests(viewer));
  ASSERT_TRUE(viewer.model().is_picked_hidden());
  const Image screen = screenshot();
  EXPECT_FALSE(is_mark(screen, kMiddle));
  int rim = 0;
  for (int x = -6; x <= 6; ++x) {
    for (int y = -6; y <= 6; ++y) rim += is_mark(screen, kMiddle + dvec2(x, y)) ? 1 : 0;
  }
  EXPECT_GT(rim, 8);
}

TEST_F(PanelRows, TellWhereATubeIsPressed) {
  Scene scene;
  CurveSpec& curve = scene.curves.emplace_back();
  curve.x = "0";
  curve.y = "0";
  curve.z = "4*s-2";
  curve.radius = Number(0.5);
  Viewer viewer(setup_of(std::move(scene)));
  ASSERT_TRUE(rests(viewer));
  double_click(viewer, kMiddle);
  EXPECT_FALSE(viewer.model().picked()) << "it has no u and v";
  double s = 0;
  double x = 0;
  double y = 0;
  settle(viewer);
  double z = 0;
  const std::string message = viewer.message();
  ASSERT_EQ(std::sscanf(message.c_str(), "curve: s %lf x %lf y %lf z %lf", &s, &x, &y, &z), 4)
      << message;
  EXPECT_NEAR(z, 4 * s - 2, 0.02);
  EXPECT_NEAR(std::hypot(x, y), 0.5, 0.02);
}

}  // namespace
}  // namespace saddle
