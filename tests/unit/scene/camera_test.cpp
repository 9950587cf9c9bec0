#include "scene/model/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/matrix.hpp>

#include "base/error.h"

namespace saddle {
namespace {

constexpr double kRounding = 1e-12;  // a few hundred operations on numbers near 1

Bounds box(const dvec3& low, const dvec3& high) {
  Bounds bounds;
  bounds.add(low);
  bounds.add(high);
  return bounds;
}

std::vector<dvec3> corners(const Bounds& b) {
  std::vector<dvec3> result;
  for (double x : {b.low.x, b.high.x}) {
    for (double y : {b.low.y, b.high.y}) {
      for (double z : {b.low.z, b.high.z}) result.emplace_back(x, y, z);
    }
  }
  return result;
}

/// On the screen: x, y, depth, each -1 to 1 inside of it.
dvec3 project(const FittedCamera& camera, const dvec3& world) {
  const glm::dvec4 clip = camera.eye_to_clip * camera.world_to_eye * glm::dvec4(world, 1);
  return dvec3(clip) / clip.w;
}

Status status_of(const Camera& camera) {
  try {
    fit_camera(camera, box(dvec3(-1), dvec3(1)), 1);
  } catch (const Error& error) {
    return error.status();
  }
  return Status::Done;
}

TEST(Camera, SeesTheTargetStraightAheadAtItsDistance) {
  Camera camera;
  camera.target = dvec3(1, 2, 3);
  camera.distance = 7;
  const FittedCamera fitted = fit_camera(camera, box(dvec3(0), dvec3(4)), 1.5);
  const glm::dvec4 target = fitted.world_to_eye * glm::dvec4(1, 2, 3, 1);
  EXPECT_NEAR(glm::length(dvec3(target) - dvec3(0, 0, -7)), 0, kRounding);
  const dvec3 eye(fitted.world_to_eye * glm::dvec4(fitted.eye, 1));
  EXPECT_NEAR(glm::length(eye), 0, kRounding);
  const dvec3 along = glm::normalize(fitted.eye - fitted.target);
  EXPECT_NEAR(glm::length(along - glm::normalize(dvec3(camera.view))), 0, kRounding);
}

TEST(Camera, IsRigidAndKeepsUpAtTheTop) {
  const FittedCamera fitted = fit_camera({}, box(dvec3(-1), dvec3(1)), 1);
  const glm::dmat3 rotation(fitted.world_to_eye);
  const glm::dmat3 product = rotation * glm::transpose(rotation);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) EXPECT_NEAR(product[i][j], i == j ? 1 : 0, kRounding);
  }
  EXPECT_NEAR(glm::determinant(rotation), 1, kRounding);
  const dvec3 up = rotation * dvec3(0, 0, 1);
  EXPECT_NEAR(up.x, 0, kRounding);
  EXPECT_GT(up.y, 0);
}

/// How far points reach in the picture: left, right, bottom, top, of half its width and height.
struct Reach {
  double left = 2, right = -2, bottom = 2, top = -2;
};

Reach reach(const FittedCamera& camera, const std::vector<dvec3>& points) {
  Reach reach;
  for (const dvec3& point : points) {
    const dvec3 seen = project(camera, point);
    reach.left = std::min(reach.left, seen.x);
    reach.right = std::max(reach.right, seen.x);
    reach.bottom = std::min(reach.bottom, seen.y);
    reach.top = std::max(reach.top, seen.y);
  }
  return reach;
}

/// A tilted ring off the origin, with a spike toward one side.
std::vector<dvec3> some_points() {
  std::vector<dvec3> points = {{7, 3, -2}};
  for (int k = 0; k < 64; ++k) {
    const double turn = k * std::numbers::pi / 32;
    points.emplace_back(3 + std::cos(turn), 2 + 2 * std::sin(turn), -4 + 0.7 * std::cos(turn));
  }
  return points;
}

TEST(Camera, FillsThePictureUpToItsMarginOnTwoOppositeSides) {
  Bounds bounds;
  for (const dvec3& point : some_points()) bounds.add(point);
  const double edge = 1 - 2 * kPictureMargin;
  for (const dvec3& view : {dvec3(2, -3, 1.5), dvec3(0, 0, 1), dvec3(-1, 0.2, -4)}) {
    for (const bool ortho : {false, true}) {
      for (const double aspect : {0.25, 1.0, 4.0}) {
        for (const double fov : {1.0, 30.0, 120.0}) {
          Camera camera;
          camera.view = view;
          camera.ortho = ortho;
          camera.fov = fov;
          ViewPyramid seen(camera, aspect, bounds.centre());
          for (const dvec3& point : some_points()) seen.add(point);
          const Reach r = reach(fit_camera(camera, bounds, aspect, &seen), some_points());
          const double wide = std::min(-r.left, r.right);
          const double high = std::min(-r.bottom, r.top);
          EXPECT_NEAR(std::max(wide, high), edge, 1e-9) << ortho << aspect << fov;
          for (const double side : {-r.left, r.right, -r.bottom, r.top}) {
            EXPECT_LE(side, edge + 1e-9) << ortho << aspect << fov;
          }
        }
      }
    }
  }
}

TEST(Camera, HoldsJoinedPyramidsAsIfTheirPointsWereOne) {
  const std::vector<dvec3> points = some_points();
  ViewPyramid all(Camera{}, 1.5, dvec3(0));
  ViewPyramid first = all;
  ViewPyramid others = all;
  for (const dvec3& point : points) all.add(point);
  first.add(points[0]);
  for (const dvec3& point : points) others.add(point);
  ASSERT_TRUE(first.fits(others));
  first.join(others);
  EXPECT_EQ(first.target(), all.target());
  EXPECT_EQ(first.distance(), all.distance());
  EXPECT_TRUE(all.holds(points[3]));
  EXPECT_FALSE(all.holds(dvec3(100, 0, 0)));
  Camera elsewhere;
  elsewhere.view = {1, 0, 0};
  EXPECT_FALSE(all.fits(ViewPyramid(elsewhere, 1.5, dvec3(0))));
}

TEST(Camera, ZoomsAroundTheMiddleOfThePicture) {
  for (const bool ortho : {false, true}) {
    Camera camera;
    camera.ortho = ortho;
    const Bounds bounds = box({-1, 2, -5}, {4, 3, 0});
    const Reach before = reach(fit_camera(camera, bounds, 1.5), corners(bounds));
    camera.zoom = 0.5;
    const Reach after = reach(fit_camera(camera, bounds, 1.5), corners(bounds));
    EXPECT_NEAR(after.left, 0.5 * before.left, kRounding);
    EXPECT_NEAR(after.top, 0.5 * before.top, kRounding);
  }
}

TEST(Camera, TurnsAroundUp) {
  Camera camera;
  camera.view = {1, 0, 2};
  camera.turn = std::numbers::pi / 2;
  const FittedCamera fitted = fit_camera(camera, box(dvec3(-1), dvec3(1)), 1);
  const dvec3 along = glm::normalize(fitted.eye - fitted.target);
  EXPECT_NEAR(glm::length(along - glm::normalize(dvec3(0, 1, 2))), 0, kRounding);
}

TEST(Camera, SeesALineFromItsEnd) {
  Camera camera;
  camera.view = {1, 0, 0};
  const Bounds line = box({-1, 0, 0}, {1, 0, 0});
  const FittedCamera fitted = fit_camera(camera, line, 1);
  EXPECT_GT(fitted.distance, 1.5);
}

TEST(Camera, FitsAroundAGivenTarget) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  Camera camera;
  camera.target = dvec3(10, 0, 0);
  for (double aspect : {0.5, 2.0}) {
    const FittedCamera fitted = fit_camera(camera, bounds, aspect);
    EXPECT_EQ(fitted.target, dvec3(*camera.target));
    for (const dvec3& corner : corners(bounds)) {
      const dvec3 seen = project(fitted, corner);
      EXPECT_LT(std::abs(seen.x), 1);
      EXPECT_LT(std::abs(seen.y), 1);
    }
  }
}

TEST(Camera, NearAndFarEncloseTheBoxWhateverTheDistance) {
  const Bounds bounds = box({-1, -2, -3}, {3, 2, 1});
  for (bool ortho : {false, true}) {
    for (double distance : {0.1, 2.0, 10.0, 1e3, 1e8, 1e20}) {
      Camera camera;
      camera.ortho = ortho;
      camera.distance = distance;
      const FittedCamera fitted = fit_camera(camera, bounds, 1);
      EXPECT_LT(fitted.near_plane, fitted.far_plane);
      if (!ortho) {
        EXPECT_GE(fitted.near_plane, 0.999e-3 * fitted.far_plane);
      }
      for (const dvec3& corner : corners(bounds)) {
        const double depth = -(fitted.world_to_eye * glm::dvec4(corner, 1)).z;
        EXPECT_LT(depth, fitted.far_plane);
        const bool in_front = depth > 2e-3 * fitted.far_plane;
        if (ortho || in_front) {
          EXPECT_LT(std::abs(project(fitted, corner).z), 1) << ortho << " " << distance;
        }
      }
    }
  }
}

TEST(Camera, NearAndFarAreTightSoThatDepthIsPrecise) {
  Camera camera;
  camera.view = {0, 0, 1};
  camera.up = {0, 1, 0};
  camera.distance = 1000;
  const FittedCamera fitted = fit_camera(camera, box(dvec3(-1), dvec3(1)), 1);
  EXPECT_NEAR(fitted.near_plane, 999, 0.1);
  EXPECT_NEAR(fitted.far_plane, 1001, 0.1);
}

TEST(Camera, SeesTheTargetOfAnEyeThatIsCloseToALargeSurface) {
  Camera camera;
  camera.view = {0, 0, 1};
  camera.up = {0, 1, 0};
  camera.distance = 1;
  const FittedCamera fitted = fit_camera(camera, box(dvec3(-1e6), dvec3(1e6)), 1);
  EXPECT_GT(fitted.far_plane, 1e6);
  EXPECT_DOUBLE_EQ(fitted.near_plane, 0.1);
}

TEST(Camera, LooksAwayFromABoxBehindTheEye) {
  Camera camera;
  camera.target = dvec3(100, 0, 0);
  camera.distance = 1;
  camera.view = {-1, 0, 0};  // the eye at 99, looking toward +x
  const FittedCamera fitted = fit_camera(camera, box(dvec3(-1), dvec3(1)), 1);
  EXPECT_GT(fitted.near_plane, 0);
  EXPECT_GT(fitted.far_plane, fitted.near_plane);
}

TEST(Camera, GivesAPointSomeRoom) {
  for (double at : {0.0, 1.0, 1e20}) {
    const FittedCamera fitted = fit_camera({}, box(dvec3(at), dvec3(at)), 1);
    EXPECT_GT(fitted.distance, 0.1);
    EXPECT_NE(fitted.eye, fitted.target);
    EXPECT_GT(fitted.near_plane, 0);
    EXPECT_GT(fitted.far_plane, fitted.near_plane);
  }
}

TEST(Camera, ReplacesAnUpVectorAlongTheView) {
  for (const dvec3& view : {dvec3(0, 0, 1), dvec3(0, 0, -3), dvec3(0, 1, 0), dvec3(1, 2, 3)}) {
    for (double sign : {1.0, -1.0}) {
      Camera camera;
      camera.view = view;
      camera.up = sign * 5.0 * view;
      const FittedCamera fitted = fit_camera(camera, box(dvec3(-1), dvec3(1)), 1);
      EXPECT_NEAR(glm::determinant(glm::dmat3(fitted.world_to_eye)), 1, kRounding);
    }
  }
}

TEST(Camera, TakesDirectionsOfAnyMagnitude) {
  const Bounds bounds = box(dvec3(-1), dvec3(1));
  const FittedCamera expected = fit_camera({}, bounds, 1);
  for (double scale : {1e-300, 1e-160, 1e160, 1e300}) {
    Camera camera;
    camera.view = scale * dvec3(camera.view);
    camera.up = scale * dvec3(camera.up);
    const FittedCamera fitted = fit_camera(camera, bounds, 1);
    EXPECT_NEAR(glm::length(fitted.eye - expected.eye), 0, kRounding) << scale;
  }
}

TEST(Camera, FitsBoxesOfAnyMagnitude) {
  for (double scale : {1e-200, 1e-8, 1e8, 1e200}) {
    const Bounds bounds = box(dvec3(-scale), dvec3(scale));
    const FittedCamera fitted = fit_camera({}, bounds, 1);
    for (const dvec3& corner : corners(bounds)) {
      const dvec3 seen = project(fitted, corner);
      EXPECT_LT(std::abs(seen.x), 1) << scale;
      EXPECT_LT(std::abs(seen.z), 1) << scale;
    }
  }
}

TEST(Camera, OrthographicHeightIsThePerspectiveOneAtTheTarget) {
  Camera camera;
  camera.view = {0, -1, 0};
  camera.distance = 10;
  const dvec3 above(0, 0, 1.5);
  const Bounds bounds = box(dvec3(-2), dvec3(2));
  const double perspective = project(fit_camera(camera, bounds, 1.7), above).y;
  camera.ortho = true;
  EXPECT_NEAR(project(fit_camera(camera, bounds, 1.7), above).y, perspective, kRounding);
}

TEST(Camera, RefusesWhatIsNoCamera) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  Camera camera;
  EXPECT_EQ(status_of(camera), Status::Done);
  for (const dvec3& bad : {dvec3(0), dvec3(nan, 1, 0), dvec3(inf, 0, 0)}) {
    camera = {};
    camera.view = bad;
    EXPECT_EQ(status_of(camera), Status::Input);
    camera = {};
    camera.up = bad;
    EXPECT_EQ(status_of(camera), Status::Input);
  }
  for (double bad : {0.0, -1.0, nan, inf}) {
    camera = {};
    camera.distance = bad;
    EXPECT_EQ(status_of(camera), Status::Input) << bad;
  }
  for (double bad : {0.0, -30.0, 180.0, nan}) {
    camera = {};
    camera.fov = bad;
    EXPECT_EQ(status_of(camera), Status::Input) << bad;
  }
}

}  // namespace
}  // namespace saddle
