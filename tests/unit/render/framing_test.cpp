#include "render/picture/framing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "scene/model/assignments.h"

namespace saddle {
namespace {

/// Of the picture's room at half the field of view.
const double kSlope = (1 - 2 * kPictureMargin) * std::tan(15 * std::numbers::pi / 180);
/// Samples miss a rim by up to (pi / 96)^2 / 2 of its radius, and moments by up to 1 / 34 of the
/// range: the camera leaves 4 % around what is seen.
constexpr double kSampling = 0.002;

/// Without a scale, which has tests of its own.
Framing framing_of(const std::vector<std::string>& assignments) {
  Scene scene;
  scene.scale.automatic = false;
  for (const std::string& text : assignments) assign(scene, text);
  Timeline timeline(scene);
  return frame_scene(timeline, 1);
}

/// A sphere of radius r in a window that is wider than high.
double fitting(double r) {
  return r / std::sin(std::atan(kSlope));
}

/// How far a sphere reaches in the picture of a camera, of half its width or height.
double reach_of_sphere(const Camera& camera, const dvec3& centre, double r) {
  Bounds bounds;
  bounds.add(centre);
  constexpr double kAspect = 4.0 / 3;
  const FittedCamera fitted = fit_camera(camera, bounds, kAspect);
  double most = 0;
  for (int k = 0; k < 4096; ++k) {
    const double turn = 0.1 * k;
    const double height = 1 - (k + 0.5) / 2048;
    const double ring = std::sqrt(1 - height * height);
    const dvec3 point = centre + r * dvec3(ring * std::cos(turn), ring * std::sin(turn), height);
    const glm::dvec4 clip = fitted.eye_to_clip * fitted.world_to_eye * glm::dvec4(point, 1);
    most = std::max({most, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
  }
  return most;
}

Camera camera_of(const Framing& framing) {
  Camera camera;
  camera.target = Vector(framing.target.value());
  camera.distance = framing.distance.value();
  return camera;
}

std::vector<std::string> sphere(std::vector<std::string> more) {
  for (const char* text :
       {"x=r*cos(u)*cos(v)+a", "y=r*sin(u)*cos(v)", "z=r*sin(v)", "u=0:tau", "v=-pi/2:pi/2"}) {
    more.emplace_back(text);
  }
  return more;
}

TEST(Framing, LeavesAStillSceneAlone) {
  const Framing framing = framing_of(sphere({"r=2", "a=0"}));
  EXPECT_FALSE(framing.target);
  EXPECT_FALSE(framing.distance);
  EXPECT_TRUE(framing.moments.empty());
}

TEST(Framing, HoldsWhatGrowsAtItsLargest) {
  const Framing framing = framing_of(sphere({"r=1+t", "a=0", "t=0:3"}));
  EXPECT_NEAR(*framing.distance, fitting(4), kSampling * fitting(4));
  EXPECT_NEAR(glm::length(*framing.target), 0, 4 * kSampling);
  EXPECT_EQ(framing.moments.size(), 1U);  // neither camera nor nodes move
}

TEST(Framing, HoldsBothEndsOfAWay) {
  const Framing framing = framing_of(sphere({"r=1", "a=t", "t=0:10"}));
  // Both ends of the way touch the margin, the one of the left and the other of the right.
  for (const double x : {0.0, 10.0}) {
    EXPECT_NEAR(reach_of_sphere(camera_of(framing), {x, 0, 0}, 1), 1 - 2 * kPictureMargin, 0.01);
  }
}

TEST(Framing, DependsOnTheRangeAlone) {
  Scene scene;
  for (const std::string& text : sphere({"r=1+t", "a=t^2", "t=0:3"})) assign(scene, text);
  Timeline one(scene);
  scene.t = 2;
  scene.animation->frames = 7;
  Timeline other(scene);
  const Framing a = frame_scene(one, 1);
  const Framing b = frame_scene(other, 2);
  EXPECT_EQ(*a.distance, *b.distance);
  EXPECT_EQ(*a.target, *b.target);
}

TEST(Framing, KeepsWhatTheSceneSays) {
  Scene scene;
  for (const std::string& text : sphere({"r=1", "a=t", "t=0:10"})) assign(scene, text);
  scene.camera.distance = 7;
  scene.camera.target = Vector(Number(std::string("t")), 0, 0);
  Timeline timeline(scene);
  const Framing framing = frame_scene(timeline, 1);
  EXPECT_FALSE(framing.target);
  EXPECT_FALSE(framing.distance);
  EXPECT_GT(framing.moments.size(), 30U);  // the camera moves
}

TEST(Framing, SeesNodesTurn) {
  Scene scene;
  for (const std::string& text : sphere({"r=1", "a=0", "t=0:1"})) assign(scene, text);
  scene.surfaces[0].in = {"arm"};
  Transform turn{Transform::Kind::Rotate, {0, 0, 1}, Number(std::string("360*t"))};
  scene.nodes = {{"arm", "", {turn, {Transform::Kind::Translate, {9, 0, 0}}}}};
  Timeline timeline(scene);
  const Framing framing = frame_scene(timeline, 1);
  // In 34 directions the nearest one to any is within 5.3 degrees or so.
  double most = 0;
  for (int k = 0; k < 360; ++k) {
    const double around = k * std::numbers::pi / 180;
    const dvec3 centre(9 * std::cos(around), 9 * std::sin(around), 0);
    most = std::max(most, reach_of_sphere(camera_of(framing), centre, 1));
  }
  EXPECT_NEAR(most, 1 - 2 * kPictureMargin, 0.02);
}

TEST(Framing, HasOneBoxForAxesAtAllTimes) {
  Scene scene;
  for (const std::string& text : sphere({"r=1", "a=3*sin(t)", "t=0:tau"})) assign(scene, text);
  EXPECT_FALSE(frame_scene(*std::make_unique<Timeline>(scene), 1).box);  // nobody asked for it
  scene.axes = true;
  Timeline timeline(scene);
  const Bounds box = frame_scene(timeline, 1).box.value();
  EXPECT_LE(box.low.x, -4 + 0.01);  // at its ends the way takes its time: no moment misses them
  EXPECT_NEAR(box.high.x, 4, 0.1);
  EXPECT_NEAR(box.high.y, 1, kSampling);  // it does not move that way: nothing is added
}

/// The farthest place of a swing is at no moment that is looked at.
TEST(Framing, HasABoxThatHoldsASwingBetweenItsMoments) {
  for (const char* const middle : {"0.49", "0.52", "0.731"}) {
    Scene scene;
    const std::string swing = std::string("a=10-300*(t-") + middle + ")^2";
    for (const std::string& text : sphere({"r=1", swing, "t=0.4:0.8"})) assign(scene, text);
    scene.axes = true;
    Timeline timeline(scene);
    EXPECT_GE(frame_scene(timeline, 1).box.value().high.x, 11) << middle;
  }
}

TEST(Framing, HasOneRangeOfColoursAtAllTimes) {
  const auto colors_of = [](const char* formula, const char* z) {
    Scene scene;
    for (const char* text : {z, "t=0:2"}) assign(scene, text);
    scene.surfaces[0].color = formula;
    Timeline timeline(scene);
    return frame_scene(timeline, 1).colors;
  };
  const auto waves = colors_of("t*u", "z=0");
  ASSERT_EQ(waves.size(), 1U);
  EXPECT_EQ(waves.at(0).low, -2);
  EXPECT_EQ(waves.at(0).high, 2);
  EXPECT_NEAR(colors_of("z", "z=1+t*(1-u^2-v^2)").at(0).high, 3, 1e-9);  // the peak is found
  EXPECT_TRUE(colors_of("u", "z=0").empty());                            // it is on the mesh itself
}

TEST(Framing, HasOneRangeOfRoundLevelsAtAllTimes) {
  Scene scene;
  for (const char* text : {"z=t*u", "t=0:2"}) assign(scene, text);
  scene.surfaces[0].contours = {{"v", {}}, {"z", {0.5}}, {"z+1", {}}};
  Timeline timeline(scene);
  const Framing framing = frame_scene(timeline, 1);
  framing.apply(scene);
  EXPECT_FALSE(scene.surfaces[0].contours[1].range);  // its levels are given
  const ColorRange range = scene.surfaces[0].contours[2].range.value();
  EXPECT_EQ(range.low, -1);
  EXPECT_EQ(range.high, 3);
}

TEST(Framing, KeepsToWhatIsClippedWhileAPoleIsJustOutside) {
  // At t = 1.01 the surface is 100 high, and nothing of it goes to infinity.
  const Framing moving = framing_of({"z=1/(u+t)", "t=-2:2"});
  EXPECT_LT(*moving.distance, fitting(10));
  EXPECT_GT(*moving.distance, fitting(4));
  // It is all that there is where the pole stays outside.
  const Framing outside = framing_of({"z=1/(u+t)", "t=1.01:2"});
  EXPECT_GT(*outside.distance, fitting(40));
}

TEST(Framing, HoldsAPeakAndCutsAPole) {
  const Framing peak = framing_of({"z=10*exp(-40*(u^2+v^2))+0*t", "t=0:1"});
  EXPECT_NEAR(peak.target->z, 5, 0.5);
  const Framing pole = framing_of({"z=1/(u^2+v^2)+0*t", "t=0:1"});
  EXPECT_LT(pole.target->z, 20);
}

std::optional<dvec3> scale_of(const std::vector<std::string>& assignments) {
  Scene scene;
  for (const std::string& text : assignments) assign(scene, text);
  Timeline timeline(scene);
  return frame_scene(timeline, 1).scale;
}

TEST(AutomaticScale, CompressesHighHeightFields) {
  const auto scale = scale_of({"z=u^2+v^2", "u=-10:10", "v=-10:10"});
  ASSERT_TRUE(scale.has_value());
  EXPECT_EQ(scale->x, 1);
  EXPECT_EQ(scale->y, 1);
  EXPECT_NEAR(scale->z * 200, 0.6 * 20, 1e-12);
  // By the larger side of the base, also where a side leans or runs backwards.
  EXPECT_NEAR(scale_of({"z=1000*u", "v=0:6"})->z * 2000, 0.6 * 6, 1e-12);
  EXPECT_NEAR(scale_of({"z=1000*v", "u=3:0", "v=0:u"})->z * 3000, 0.6 * 3, 1e-12);
  EXPECT_TRUE(scale_of({"x=u", "y=(v)", "z=100*u"})) << "by formula";
}

TEST(AutomaticScale, LeavesOtherSurfacesAlone) {
  EXPECT_FALSE(scale_of({"z=8*u", "u=0:1", "v=0:1"})) << "8 times is not more than that";
  EXPECT_TRUE(scale_of({"z=8.01*u", "u=0:1", "v=0:1"}));
  EXPECT_FALSE(scale_of({"z=u/1000"})) << "nothing is stretched up";
  EXPECT_FALSE(scale_of({"x=u*2", "z=100*u"})) << "no height field";
  EXPECT_FALSE(scale_of({"x=v", "y=u", "z=100*u"}));
  EXPECT_FALSE(scale_of({"z=1/u"})) << "its pole is clipped";
  EXPECT_FALSE(scale_of({"z=1/(u-u)"})) << "nothing is there";
}

TEST(AutomaticScale, IsForAllSurfacesTogether) {
  Scene scene;
  assign(scene, "z=100*u");
  SurfaceSpec wide = scene.surfaces[0];
  wide.z = "0";
  wide.u = {"-20", "20"};
  scene.surfaces.push_back(wide);
  Timeline beside(scene);
  EXPECT_FALSE(frame_scene(beside, 1).scale) << "200 is 5 times 40";
  scene.surfaces[1].u = {"-5", "5"};
  Timeline narrow(scene);
  EXPECT_NEAR(frame_scene(narrow, 1).scale.value().z * 200, 0.6 * 10, 1e-12);
  scene.surfaces[1].in = {"node"};
  scene.nodes = {{"node", "", {}}};
  Timeline moved(scene);
  EXPECT_FALSE(frame_scene(moved, 1).scale) << "a node may turn it";
}

TEST(AutomaticScale, IsOneForAllFrames) {
  const auto scale = scale_of({"z=t*u", "t=0:100"});
  EXPECT_NEAR(scale.value().z * 200, 0.6 * 2, 1e-12);
  Scene scene;
  for (const char* text : {"z=t*u", "t=0:100"}) assign(scene, text);
  Timeline timeline(scene);
  const Framing framing = frame_scene(timeline, 1);
  // 1.2 high: the camera is as near as for that.
  EXPECT_LT(*framing.distance, fitting(2));
  Scene frame = timeline.at(50);
  framing.apply(frame);
  EXPECT_EQ(frame.scale.factors.z.value, scale->z);
  EXPECT_NEAR(frame.camera.target->z * scale->z, framing.target->z, 1e-12) << "in true units";
}

TEST(MomentsOfStill, PlaceTheCameraOfSeveralSurfacesAndOfNoSingleOne) {
  Scene scene;
  for (const std::string& text : sphere({"r=1", "a=0"})) assign(scene, text);
  scene = resolve(scene);
  EXPECT_TRUE(moments_of_still(scene, 1).empty());
  scene.surfaces.push_back(scene.surfaces[0]);
  scene.surfaces[0].x = "7+" + scene.surfaces[0].x;
  const std::vector<Moment> moments = moments_of_still(scene, 1);
  ASSERT_EQ(moments.size(), 1U);
  const Camera& camera = moments[0].camera;
  // The picture's room holds both spheres and is filled by them, but for what samples miss.
  const double reach =
      std::max(reach_of_sphere(camera, {0, 0, 0}, 1), reach_of_sphere(camera, {7, 0, 0}, 1));
  EXPECT_NEAR(reach, 1 - 2 * kPictureMargin, 0.01);
  scene.camera.distance = Number(50);
  EXPECT_EQ(moments_of_still(scene, 1)[0].camera.distance->value, 50);
}

}  // namespace
}  // namespace saddle
