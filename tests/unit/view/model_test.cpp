// The viewer's model without a window.
#include "view/model/model.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <functional>
#include <new>
#include <semaphore>
#include <utility>
#include <vector>

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
    EXPECT_NO_THROW(check_camera(model->scene().camera)) << size;
    EXPECT_NO_THROW(model->grip()) << size;
  }
}

TEST(Model, MovesTheCameraWithTheHand) {
  PlaneModel model("1");
  const dvec3 before = model->grip().fitted.target;
  const Grip grip = model->grip();
  model->look_through(moved(grip, grip.fitted.target, {200, 150}, {250, 150}));
  EXPECT_GT(glm::distance(model->grip().fitted.target, before), 0.1);
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
  ASSERT_TRUE(model->error());
  EXPECT_STREQ(model->error()->what(), "out of memory");
  EXPECT_EQ(model->meshes().size(), 1);
}

}  // namespace
}  // namespace saddle
