// The hand and the camera: what it holds stays under it, and nothing jumps.
#include "view/model/controls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "base/random.h"

namespace saddle {
namespace {

constexpr double kRounding = 1e-10;  // some hundred operations on pixels, of about 1000

Bounds unit_box() {
  Bounds bounds;
  bounds.add(dvec3(-1));
  bounds.add(dvec3(1));
  return bounds;
}

/// The surface's room is beside a colour bar.
Grip grip_of(const Camera& camera) {
  const dvec2 size(800, 600);
  Room room;
  room.middle = -0.125;
  ViewPyramid seen(camera, size.x / size.y, dvec3(0), room);
  seen.add(unit_box());
  return {camera, fit_camera(camera, unit_box(), size.x / size.y, &seen), size};
}

dvec3 unit(const dvec3& v) {
  return glm::normalize(v);
}

void expect_near(const dvec3& a, const dvec3& b, double tolerance) {
  EXPECT_NEAR(glm::length(a - b), 0, tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

/// A few cameras of each kind, and what is in the midst of the picture and off it.
std::vector<Camera> cameras() {
  Camera far_off;
  far_off.target = dvec3(0.2, -0.1, 0.4);
  far_off.distance = 9;
  far_off.view = {-1, 0.3, -2};
  far_off.fov = 70;
  std::vector<Camera> result{Camera{}, far_off};
  for (Camera camera : {Camera{}, far_off}) {
    camera.ortho = true;
    result.push_back(camera);
  }
  return result;
}

dvec2 pixel_of(const Grip& grip, const dvec3& point) {
  return saddle::pixel_of(grip.fitted, point, grip.size).value();
}

TEST(Controls, SeeThePointThatAPixelShows) {
  for (const Camera& camera : cameras()) {
    const Grip grip = grip_of(camera);
    for (const dvec2& pixel : {dvec2(400, 300), dvec2(10, 590), dvec2(700, 20)}) {
      const Ray ray = ray_through(grip, pixel);
      EXPECT_NEAR(glm::length(ray.direction), 1, kRounding);
      for (double t : {1.0, 3.0}) {
        const dvec2 back = pixel_of(grip, ray.origin + t * ray.direction);
        EXPECT_NEAR(glm::length(back - pixel), 0, kRounding * 1000);
      }
    }
  }
}

TEST(Ball, IsWhereItWasWhenTheHandIsBack) {
  const Grip grip = grip_of(Camera{});
  const Camera camera = turned_on_ball(grip, {100, 500}, {100, 500});
  expect_near(unit(camera.view), unit(grip.camera.view), kRounding);
}

TEST(Ball, TurnsWhatIsInFrontWithTheHand) {
  const Grip grip = grip_of(Camera{});
  // The point of the ball that is nearest to the eye, at a radius where the ball is the sphere.
  const dvec3 front = grip.fitted.target + unit(grip.camera.view);
  const Grip after = grip_of(turned_on_ball(grip, {350, 300}, {450, 300}));
  EXPECT_GT(pixel_of(after, front).x, 400);
  EXPECT_NEAR(pixel_of(after, front).y, 300, kRounding * 1000);
  const double sine = 100.0 / 300;
  EXPECT_NEAR(degrees_between(after.camera.view, grip.camera.view),
              std::asin(sine) * 180 / std::numbers::pi, kRounding * 1000);
}

TEST(Ball, NeverJumps) {
  // Random walks over the picture and beyond its borders: a pixel turns at most by so much.
  const double most = 2.0 / 300 * 180 / std::numbers::pi;
  Grip grip = grip_of(Camera{});
  dvec2 place(400, 300);
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const double angle = 2 * std::numbers::pi * random_unit(i);
    const dvec2 next = place + dvec2(std::cos(angle), std::sin(angle));
    const Grip after = grip_of(turned_on_ball(grip, place, next));
    EXPECT_LE(degrees_between(after.camera.view, grip.camera.view), most);
    const glm::dmat4& eye = grip.fitted.world_to_eye;
    EXPECT_LE(degrees_between(after.camera.up, {eye[0].y, eye[1].y, eye[2].y}), most);
    EXPECT_NEAR(glm::dot(dvec3(after.camera.view), dvec3(after.camera.up)), 0, kRounding);
    grip = after;
    place = next + dvec2(7 * std::cos(0.01 * static_cast<double>(i)), 0);
  }
}

TEST(Table, KeepsUpUpAndStopsAtThePoles) {
  Grip grip = grip_of(Camera{});
  const dvec3 up(0, 0, 1);
  Camera camera = turned_on_table(grip, up, {400, 300}, {400, 3000});
  EXPECT_NEAR(degrees_between(camera.view, up), 0, 1e-3);
  // From the pole, sideways and back down, without a jump.
  grip = grip_of(camera);
  camera = turned_on_table(grip, up, {0, 0}, {1, 0});
  EXPECT_LT(degrees_between(camera.view, grip.camera.view), 1e-3);
  camera = turned_on_table(grip, up, {0, 300}, {0, 0});
  EXPECT_NEAR(degrees_between(camera.view, up), 90, 1e-3);
}

TEST(Table, TurnsWhatIsInFrontWithTheHand) {
  const Grip grip = grip_of(Camera{});
  const dvec3 front = grip.fitted.target + unit(grip.camera.view);
  const Grip right = grip_of(turned_on_table(grip, {0, 0, 1}, {0, 0}, {30, 0}));
  EXPECT_GT(pixel_of(right, front).x, pixel_of(grip, front).x + 10);
  const Grip down = grip_of(turned_on_table(grip, {0, 0, 1}, {0, 0}, {0, 30}));
  EXPECT_GT(pixel_of(down, front).y, pixel_of(grip, front).y + 10);
}

TEST(Moving, KeepsWhatIsHeldUnderTheHand) {
  for (const Camera& camera : cameras()) {
    const Grip grip = grip_of(camera);
    const Ray ray = ray_through(grip, {250, 400});
    const dvec3 held = ray.origin + 0.7 * grip.fitted.distance * ray.direction;
    const Grip after = grip_of(moved(grip, held, {250, 400}, {300, 123}));
    EXPECT_NEAR(glm::length(pixel_of(after, held) - dvec2(300, 123)), 0, kRounding * 1000);
    EXPECT_EQ(dvec3(after.camera.view), dvec3(grip.camera.view));
  }
}

TEST(Zooming, KeepsWhatIsUnderThePointer) {
  for (const Camera& camera : cameras()) {
    const Grip grip = grip_of(camera);
    const Ray ray = ray_through(grip, {600, 100});
    const dvec3 fixed = ray.origin + 0.9 * grip.fitted.distance * ray.direction;
    for (double factor : {0.5, 0.9, 1.7}) {
      const Grip after = grip_of(zoomed(grip, fixed, factor, 2));
      EXPECT_NEAR(after.fitted.distance, factor * grip.fitted.distance, kRounding * 100);
      EXPECT_NEAR(glm::length(pixel_of(after, fixed) - dvec2(600, 100)), 0, kRounding * 1000);
    }
  }
}

TEST(Zooming, EndsBeforeNumbersDo) {
  Grip grip = grip_of(Camera{});
  for (int i = 0; i < 500; ++i) grip = grip_of(zoomed(grip, dvec3(0), 0.5, 2));
  EXPECT_DOUBLE_EQ(grip.fitted.distance, 2e-4);
  for (int i = 0; i < 500; ++i) grip = grip_of(zoomed(grip, dvec3(0), 2, 2));
  EXPECT_DOUBLE_EQ(grip.fitted.distance, 2e3);
}

TEST(Zooming, IsTheSameInOneTurnOfTheWheelAsInMany) {
  EXPECT_NEAR(std::pow(zoom_factor(0.1), 10), zoom_factor(1), kRounding);
  EXPECT_LT(zoom_factor(1), 1);
  EXPECT_NEAR(zoom_factor(2) * zoom_factor(-2), 1, kRounding);
}

TEST(Controls, SeeBothSidesOfAnAxis) {
  Camera camera = seen_along(Camera{}, 0);
  EXPECT_EQ(dvec3(camera.view), dvec3(1, 0, 0));
  camera = seen_along(camera, 0);
  EXPECT_EQ(dvec3(camera.view), dvec3(-1, 0, 0));
  camera = seen_along(camera, 2);
  EXPECT_EQ(dvec3(camera.view), dvec3(0, 0, 1));
  EXPECT_EQ(dvec3(camera.up), dvec3(0, 1, 0));
}

TEST(Controls, FitAgainFollowsTheSurface) {
  const Grip grip = grip_of(Camera{});
  const Camera camera = zoomed(grip, dvec3(1), 0.3, 2);
  EXPECT_TRUE(camera.target && camera.distance);
  const Camera again = fit_again(camera);
  EXPECT_FALSE(again.target || again.distance);
}

}  // namespace
}  // namespace saddle
