// The viewer's model without a window.
#include "view/model.h"

#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <new>
#include <semaphore>
#include <utility>

#include "view/hand.h"

namespace saddle {
namespace {

/// A model of a plane, meshed.
class PlaneModel {
 public:
  explicit PlaneModel(const std::string& size, std::function<Scene()> reload = {})
      : model_(setup(size, std::move(reload)), [this] { meshed_.release(); }) {
    while (!model_.take_result() || model_.last_good().preview) {
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

TEST(Model, KeepsItsMeshesWhereReloadingThrowsWhatIsNoError) {
  PlaneModel model("1", []() -> Scene { throw std::bad_alloc(); });
  EXPECT_TRUE(model->act(Action::Reload));
  ASSERT_TRUE(model->error());
  EXPECT_STREQ(model->error()->what(), "out of memory");
  EXPECT_EQ(model->meshes().size(), 1);
}

}  // namespace
}  // namespace saddle
