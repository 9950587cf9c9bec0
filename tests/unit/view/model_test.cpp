// The viewer's model without a window.
#include "view/model/model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <new>
#include <optional>
#include <semaphore>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "scene/toml/scene_file.h"
#include "view/model/hand.h"

namespace saddle {
namespace {

/// A model of a plane, meshed.
class PlaneModel {
 public:
  explicit PlaneModel(const std::string& size, std::function<Scene()> reload = {})
      : model_(setup(size, std::move(reload)), [this] { meshed_.release(); }) {
    wait();
  }

  /// Until the mesh is that of the scene, or the scene is wrong.
  void wait() {
    while (!model_.take_result() || (model_.last_good().preview && !model_.error())) {
      if (!meshed_.try_acquire_for(std::chrono::seconds(30))) break;
    }
  }
  Model& operator*() { return model_; }
  Model* operator->() { return &model_; }

 private:
  static ViewerSetup setup(const std::string& size, std::function<Scene()> reload) {
    ViewerSetup result;
    result.reload = std::move(reload);
    SurfaceSpec& plane = result.scene.surfaces.emplace_back();
    plane.x = size + "*u";
    plane.y = size + "*v";
    plane.z = "0";
    result.scene.picture.width = 400;
    result.scene.picture.height = 300;
    result.threads = 1;
    return result;
  }

  std::counting_semaphore<> meshed_{0};
  Model model_;
};

TEST(Model, KeepsTheCameraWhereAHandWouldLeadBeyondNumbers) {
  for (const char* size : {"1", "1e150", "1e300", "1e307"}) {
    PlaneModel model(size);
    ASSERT_EQ(model->meshes().size(), 1) << size;
    for (const dvec2& to : {dvec2(399, 299), dvec2(0, 0), dvec2(-1e6, 1e6)}) {
      for (int i = 0; i < 5; ++i) {
        const Grip grip = model->grip();
        model->look_through(moved(grip, model->under({200, 150}), {200, 150}, to));
        model->look_through(zoomed(model->grip(), model->under(to), zoom_factor(-9), 1e308));
        model->look_through(turned_on_ball(model->grip(), {200, 150}, to));
      }
    }
    EXPECT_TRUE(is_possible(model->scene().camera)) << size;
    EXPECT_NO_THROW(model->grip()) << size;
  }
}

TEST(Model, RestsWhereANumberIsWrong) {
  PlaneModel model("1");
  Scene scene = model->scene();
  scene.surfaces[0].opacity = Number("1/0");
  model->edit(std::move(scene), "");
  ASSERT_TRUE(model->error());
  model->resize({300, 300});
  // The thread that made the plane's mesh may not have come to rest.
  while (model->is_meshing()) std::this_thread::yield();
  ASSERT_TRUE(model->next_pass());
  model->pass(*model->next_pass());
  EXPECT_FALSE(model->next_pass()) << "there is no mesh to wait for";
}

TEST(Model, MovesTheCameraWithTheHand) {
  PlaneModel model("1");
  const dvec3 before = model->grip().fitted.target;
  const Grip grip = model->grip();
  model->look_through(moved(grip, grip.fitted.target, {200, 150}, {250, 150}));
  EXPECT_GT(glm::distance(model->grip().fitted.target, before), 0.1);
}

TEST(Hand, LetsGoWhereTheWheelTurns) {
  PlaneModel model("1");
  Hand hand;
  hand.press(*model, {200, 150}, 0, false);
  EXPECT_TRUE(hand.move(*model, {220, 150}));
  hand.scroll(*model, {200, 150}, 1);
  const double near = model->grip().fitted.distance;
  EXPECT_FALSE(hand.move(*model, {240, 150}));  // the camera would go back to where it was pressed
  EXPECT_EQ(model->grip().fitted.distance, near);
}

/// Does what edits do, until it is meshed.
void edit(PlaneModel& model, const std::function<void(Scene&)>& change) {
  Scene scene = model->scene();
  change(scene);
  model->edit(std::move(scene), "");
  model.wait();
}

void pick_somewhere(PlaneModel& model) {
  model->pick({220, 160});
  ASSERT_TRUE(model->picked());
}

TEST(PickedPoint, FollowsEdits) {
  PlaneModel model("1");
  pick_somewhere(model);
  const dvec2 uv = model->picked()->place.uv;
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "u*v+3"; });
  ASSERT_TRUE(model->picked());
  const SurfacePlace& place = model->picked()->place;
  EXPECT_EQ(place.uv, uv);
  EXPECT_DOUBLE_EQ(place.position.z, uv.x * uv.y + 3);
  EXPECT_EQ(model->picked()->world, place.position);
  // The normal of z = u v + 3 is along (-v, -u, 1); K = -1 / (1 + u^2 + v^2)^2.
  const double square = 1 + uv.x * uv.x + uv.y * uv.y;
  ASSERT_TRUE(place.normal);
  EXPECT_NEAR(glm::distance(*place.normal, dvec3(-uv.y, -uv.x, 1) / std::sqrt(square)), 0, 1e-15);
  EXPECT_NEAR(place.curvature.gauss, -1 / (square * square), 1e-15);
  EXPECT_FALSE(model->take_news());
}

TEST(PickedPoint, FollowsTime) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "t*u"; });
  pick_somewhere(model);
  const dvec2 uv = model->picked()->place.uv;
  for (const double t : {0.25, 0.75}) {
    model->set_time(t);
    model.wait();
    ASSERT_TRUE(model->picked());
    EXPECT_EQ(model->picked()->place.uv, uv);
    EXPECT_DOUBLE_EQ(model->picked()->world.z, t * uv.x);
  }
}

TEST(PickedPoint, FollowsItsSurfaceAndItsNode) {
  PlaneModel model("1");
  pick_somewhere(model);
  const dvec2 uv = model->picked()->place.uv;
  edit(model, [](Scene& scene) {
    SurfaceSpec other = scene.surfaces[0];
    other.name = "other";
    other.z = "7";
    scene.surfaces.insert(scene.surfaces.begin(), other);
  });
  ASSERT_TRUE(model->picked());
  EXPECT_EQ(model->picked()->place.uv, uv);
  EXPECT_EQ(model->picked()->world.z, 0);
}

TEST(PickedPoint, FollowsWhereTheEndsOfVDependOnU) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) {
    scene.surfaces[0].u = {"-1", "1"};
    scene.surfaces[0].v = {"-1", "u+3"};
  });
  pick_somewhere(model);
  const dvec2 uv = model->picked()->place.uv;
  edit(model, [](Scene& scene) { scene.surfaces[0].v.max = "u^2+4"; });
  ASSERT_TRUE(model->picked());
  EXPECT_EQ(model->picked()->place.uv, uv);
  EXPECT_NEAR(glm::distance(model->picked()->world, dvec3(uv, 0)), 0, 1e-14);
}

TEST(PickedPoint, GoesWithItsPlaceAndSaysSo) {
  const std::vector<std::function<void(Scene&)>> edits{
      [](Scene& scene) { scene.surfaces[0].name = "another"; },
      [](Scene& scene) {
        scene.surfaces[0].u = {"5", "6"};
      },
      [](Scene& scene) { scene.surfaces[0].z = "u > 0.9 ? 0 : 0/0"; },
  };
  for (const auto& change : edits) {
    PlaneModel model("1");
    pick_somewhere(model);
    edit(model, change);
    EXPECT_FALSE(model->error());
    EXPECT_FALSE(model->picked());
    const auto news = model->take_news();
    ASSERT_TRUE(news);
    EXPECT_TRUE(news->starts_with("the picked point is gone")) << *news;
    EXPECT_FALSE(model->take_news()) << "once";
  }
}

TEST(PickedPoint, StaysWhileTheSceneIsWrong) {
  PlaneModel model("1");
  pick_somewhere(model);
  const dvec3 world = model->picked()->world;
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "u+"; });
  ASSERT_TRUE(model->error());
  ASSERT_TRUE(model->picked());
  EXPECT_EQ(model->picked()->world, world);
}

TEST(Model, KeepsItsMeshesWhereReloadingThrowsWhatIsNoError) {
  PlaneModel model("1", []() -> Scene { throw std::bad_alloc(); });
  EXPECT_TRUE(model->act(Action::Reload));
  EXPECT_FALSE(model->error()) << "nothing is wrong with the scene that is shown";
  EXPECT_EQ(model->take_news(), "out of memory");
  EXPECT_EQ(model->meshes().size(), 1);
}

TEST(PickedPoint, IsHiddenBehindASurface) {
  PlaneModel model("1");
  const auto look_from = [&](double height) {
    Camera camera = model->scene().camera;
    camera.view = Vector(0.3, 0.2, height);
    model->look_through(camera);
  };
  edit(model, [](Scene& scene) {
    SurfaceSpec above = scene.surfaces[0];
    above.name = "above";
    above.z = "0.5";
    scene.surfaces.push_back(above);
  });
  look_from(2);
  pick_somewhere(model);
  EXPECT_EQ(model->picked()->surface, "above");
  EXPECT_FALSE(model->is_picked_hidden());
  look_from(-2);
  EXPECT_TRUE(model->is_picked_hidden());
  edit(model, [](Scene& scene) { scene.surfaces[0].visible = false; });
  EXPECT_FALSE(model->is_picked_hidden()) << "what is not drawn hides nothing";
}

TEST(Model, MakesNoMeshAnewForAColourOrForAnotherSurface) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) {
    scene.definitions = {{"a", "1"}, {"b", "1"}};
    SurfaceSpec other = scene.surfaces[0];
    other.name = "other";
    other.z = "a*u";
    scene.surfaces.push_back(other);
  });
  const auto before = model->meshes();
  edit(model, [](Scene& scene) {
    scene.surfaces[0].front.diffuse = {1, 0, 0};
    scene.background = {1, 1, 1, 1};
    scene.definitions[1].text = "2";
  });
  EXPECT_EQ(model->meshes(), before);
  edit(model, [](Scene& scene) { scene.definitions[0].text = "2"; });
  EXPECT_EQ(model->meshes()[0], before[0]);
  EXPECT_NE(model->meshes()[1], before[1]);
  edit(model, [](Scene& scene) { scene.definitions[1].text = "2+"; });
  EXPECT_TRUE(model->error()) << "though no surface uses it";
}

/// The state in words.
std::string words_of(const Model& model) {
  const ViewState& view = model.view();
  return write_scene(model.scene()) + (view.grid ? "grid " : "") +
         (view.wireframe ? "wires " : "") + (view.normals ? "normals " : "") +
         (view.turntable ? "table " : "") + (view.panel ? "panel " : "");
}

TEST(Model, UndoesEveryActionAndDoesItAgain) {
  PlaneModel model("1");
  std::vector<std::string> states{words_of(*model)};
  for (const Action action :
       {Action::Grid, Action::Wireframe, Action::Normals, Action::Turntable, Action::NextLights,
        Action::ShadeExactly, Action::Axes, Action::Orthographic, Action::AlongX, Action::Fit,
        Action::Flip, Action::Coarser, Action::AddSurface, Action::AddCurve, Action::AddPoint,
        Action::AddLight, Action::NextLights, Action::Panel, Action::New}) {
    ASSERT_TRUE(model->act(action));
    model->end_edit();
    if (action == Action::Fit)
      continue;  // which changes nothing, unless a hand has moved the camera
    EXPECT_NE(words_of(*model), states.back()) << row_of(action).name;
    states.push_back(words_of(*model));
  }
  const auto step_back = [&] { model->act(Action::Undo); };
  const std::string last = states.back();
  int steps = 0;
  for (; model->has(Needs::Past); ++steps) step_back();
  EXPECT_EQ(words_of(*model), states.front()) << "undo to the start gives the first scene back";
  for (; steps > 0; --steps) model->act(Action::Redo);
  EXPECT_EQ(words_of(*model), last);
  EXPECT_FALSE(model->has(Needs::Future));
}

TEST(Model, TakesTheCameraBackWithTheSceneThatWasOpened) {
  PlaneModel model("1");
  const Camera before = model->scene().camera;
  Scene other = model->scene();
  other.camera.view = Vector(0, 0, 1);
  model->open(other, {});
  EXPECT_EQ(dvec3(model->scene().camera.view), dvec3(0, 0, 1));
  model->undo();
  EXPECT_EQ(dvec3(model->scene().camera.view), dvec3(before.view));
}

TEST(Model, TakesEachDragAndTurnsOfTheWheelBackAtOnce) {
  PlaneModel model("1");
  const Model& now = *model;
  Hand hand;
  const auto drag = [&](double to) {
    hand.press(now, {200, 150}, 0, false);
    for (const double x : {210.0, 220.0, to}) hand.move(*model, {x, 150});
    hand.release(*model, 0);
  };
  std::vector<std::string> states{words_of(now)};
  const auto note = [&] { states.push_back(words_of(now)); };
  drag(240);
  note();
  drag(300);
  note();
  hand.scroll(*model, {200, 150}, 1);
  hand.scroll(*model, {200, 150}, 1);
  note();
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "u"; });
  note();
  for (std::size_t i = states.size() - 1; i > 0; --i) {
    EXPECT_NE(states[i], states[i - 1]);
    EXPECT_EQ(words_of(now), states[i]) << i;
    model->undo();
  }
  EXPECT_EQ(words_of(now), states[0]);
  EXPECT_FALSE(now.has(Needs::Past));
}

TEST(Model, TakesTheMomentAndPlayingBack) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "t*u"; });
  for (const double t : {0.1, 0.2, 0.3}) model->set_time(t);
  model->act(Action::Play);
  const auto begin = Model::Clock::now();
  for (int i = 0; i < 4; ++i) model->pass(begin + i * std::chrono::milliseconds(50));
  EXPECT_NE(model->scene().t, 0.3);
  model->act(Action::Play);
  EXPECT_FALSE(model->view().playing);
  model->undo();
  EXPECT_EQ(model->scene().t, 0.3) << "playing is one change, from its start to its end";
  model->undo();
  EXPECT_EQ(model->scene().t, 0) << "a drag of the slider is one";
}

TEST(Model, MeshesNothingBeforeTimeHasPassed) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "t*u"; });
  ASSERT_FALSE(model->is_meshing());
  model->act(Action::Play);
  const auto begin = Model::Clock::now();
  model->pass(begin);
  EXPECT_FALSE(model->is_meshing() || model->take_result())
      << "the surface of this moment is shown already";
  model->pass(begin + std::chrono::milliseconds(50));
  EXPECT_GT(model->scene().t, 0);
}

TEST(Model, KeepsTheNextLightsThroughUndo) {
  PlaneModel model("1");
  const std::size_t own = model->scene().lights.size();
  Scene other = model->scene();
  model->open(other, {});
  model->undo();
  model->act(Action::NextLights);
  EXPECT_EQ(model->scene().lights.size(), 1U);
  model->undo();
  EXPECT_EQ(model->scene().lights.size(), own);
  model->redo();
  EXPECT_EQ(model->scene().lights.size(), 1U);
  model->act(Action::NextLights);
  model->act(Action::NextLights);
  EXPECT_EQ(model->scene().lights.size(), own) << "once round";
}

TEST(Model, PlaysOnlyWhatMoves) {
  PlaneModel model("1");
  EXPECT_FALSE(model->moves());
  model->act(Action::Play);
  EXPECT_FALSE(model->view().playing);
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "t*u"; });
  EXPECT_TRUE(model->has(Needs::Movement));
  model->act(Action::Play);
  EXPECT_TRUE(model->view().playing);
  edit(model, [](Scene& scene) { scene.surfaces[0].z = "u"; });
  EXPECT_FALSE(model->view().playing);
  edit(model, [](Scene& scene) { scene.lights[0].position.x = Number("t"); });
  EXPECT_TRUE(model->moves()) << "a light does";
}

TEST(Model, PlaysAParameterToAndFroAndUndoesThatAtOnce) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) {
    scene.definitions = {{"a", "1"}};
    scene.sliders = {{"a", 0, 2}};
    scene.surfaces[0].z = "a*u";
  });
  model->play(ParameterPlace{{}, "a"});
  const auto begin = Model::Clock::now();
  double least = 1;
  double most = 1;
  for (int i = 0; i <= 120; ++i) {
    model->pass(begin + i * std::chrono::milliseconds(50));
    const double a = std::stod(model->scene().definitions[0].text);
    least = std::min(least, a);
    most = std::max(most, a);
  }
  EXPECT_LT(least, 0.1);
  EXPECT_GT(most, 1.9);
  model->undo();
  EXPECT_EQ(model->scene().definitions[0].text, "1");
  EXPECT_FALSE(model->played());
}

TEST(Model, PlaysAParameterOnceOrAgainAndAgain) {
  PlaneModel model("1");
  edit(model, [](Scene& scene) {
    scene.definitions = {{"a", "1"}};
    scene.sliders = {{"a", 0, 2}};
    scene.surfaces[0].z = "a*u";
  });
  const auto play = [&](PlayManner manner) {
    ViewState view = model->view();
    view.manner = manner;
    model->change_view(view, "");
    model->play({});
    const auto begin = Model::Clock::now();
    model->pass(begin);  // time begins anew
    model->play(ParameterPlace{{}, "a"});
    std::vector<double> values;
    for (int i = 0; i <= 125 && model->played(); ++i) {
      model->pass(begin + i * std::chrono::milliseconds(50));
      values.push_back(std::stod(model->scene().definitions[0].text));
    }
    return values;
  };
  const std::vector<double> once = play(PlayManner::Once);
  EXPECT_TRUE(std::ranges::is_sorted(once));
  EXPECT_EQ(once.back(), 2);
  EXPECT_FALSE(model->played()) << "it has stopped at the end";
  EXPECT_EQ(play(PlayManner::Once).front(), 0) << "from the beginning again";
  const std::vector<double> again = play(PlayManner::Again);
  int jumps = 0;
  for (std::size_t i = 1; i < again.size(); ++i) jumps += again[i] < again[i - 1] ? 1 : 0;
  EXPECT_EQ(jumps, 2) << "a little more than six seconds are twice the way";
  EXPECT_TRUE(model->played());
}

TEST(Model, IsAsFineAsCanBeSeen) {
  PlaneModel model("1");
  for (int i = 0; i < 12; ++i) model->act(Action::Finer);
  EXPECT_GE(model->tolerance().value, 1.0 / 16);
  EXPECT_TRUE(model->take_news());
}

TEST(Model, StaysAsCoarseAsCanBeUndoneByAFewKeys) {
  for (const std::optional<ToleranceValue> first :
       {std::optional<ToleranceValue>(), std::optional(ToleranceValue{1e-3, false})}) {
    PlaneModel model("1");
    Scene scene = model->scene();
    scene.mesh.tolerance = first;
    model->edit(scene, "");
    for (int i = 0; i < 30; ++i) model->act(Action::Coarser);
    const ToleranceValue coarsest = *model->scene().mesh.tolerance;
    EXPECT_LE(coarsest.value, coarsest.pixels ? 64 : 0.25);
    const auto news = model->take_news();
    ASSERT_TRUE(news);
    EXPECT_NE(news->find("coarser"), std::string::npos) << *news;
    model->act(Action::Finer);
    EXPECT_EQ(model->scene().mesh.tolerance->value, coarsest.value / 2);
  }
}

}  // namespace
}  // namespace saddle
