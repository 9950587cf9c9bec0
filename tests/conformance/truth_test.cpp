// The truth that methods are measured against, where it is known on paper.
#include "study/truth.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "study_subject.h"

namespace saddle {
namespace {

constexpr double kPi = std::numbers::pi;

std::optional<dvec3> normal_at(const Scene& scene, dvec2 corner, dvec2 inside) {
  const Truth truth(scene, scene.surfaces[0]);
  const Approach approach{corner, inside};
  return truth.normals(std::span(&approach, 1), 1)[0];
}

void expect_near(const std::optional<dvec3>& normal, const dvec3& expected) {
  ASSERT_TRUE(normal.has_value());
  // A double's rounding of each component.
  EXPECT_LT(glm::distance(*normal, expected), 4e-16);
}

TEST(Truth, HasPositionsTo32Digits) {
  const Scene scene = scene_of("sqrt(2)+0*u", "pi", "v/3");
  const Truth truth(scene, scene.surfaces[0]);
  const dvec2 at(0, 1);
  const TruePosition p = truth.positions(std::span(&at, 1), 1)[0];
  EXPECT_EQ(p.value, dvec3(std::sqrt(2.0), kPi, 1.0 / 3));
  // The digits of sqrt(2), pi and 1/3 past their doubles.
  EXPECT_NEAR(p.rest.x, -9.667293313452913e-17, 1e-31);
  EXPECT_NEAR(p.rest.y, 1.2246467991473532e-16, 1e-31);
  EXPECT_NEAR(p.rest.z, 1.8503717077085941e-17, 1e-31);
}

TEST(Truth, IsOfTheFormulaAtItsMomentWithItsParameters) {
  Scene scene = scene_of("a*u", "diff(a^2*u,a)", "t");
  scene.definitions = {{"a", "1.5"}};
  scene.t = 0.25;
  const Truth truth(scene, scene.surfaces[0]);
  const dvec2 at(0.5, 0);
  EXPECT_EQ(truth.positions(std::span(&at, 1), 1)[0].value, dvec3(0.75, 1.5, 0.25));
}

TEST(Truth, HasThePartOfTheWayForVWhereItsEndsDependOnU) {
  const Scene scene = scene_of("u", "v", "u*v", {"0", "1"}, {"0", "1-u"});
  const Truth truth(scene, scene.surfaces[0]);
  const dvec2 at(0.25, 0.5);
  EXPECT_EQ(truth.positions(std::span(&at, 1), 1)[0].value, dvec3(0.25, 0.375, 0.09375));
}

TEST(Truth, HasTheNormalOfASpheresPole) {
  const Scene scene =
      scene_of("cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)", {"0", "2*pi"}, {"-pi/2", "pi/2"});
  expect_near(normal_at(scene, {0.3, kPi / 2}, {0.4, 1.5}), {0, 0, 1});
}

TEST(Truth, HasTheNormalOfAConesApexFromEachSide) {
  const Scene scene = scene_of("v*cos(u)", "v*sin(u)", "v", {"0", "2*pi"});
  const double s = std::sqrt(0.5);
  // r_u x r_v = v (cos u, sin u, -1): it turns over at the apex.
  const dvec2 above = {1, 0.1};
  const dvec2 below = {1, -0.1};
  const dvec3 n = s * dvec3(std::cos(1.0), std::sin(1.0), -1);
  expect_near(normal_at(scene, {1, 0}, above), n);
  expect_near(normal_at(scene, {1, 0}, below), -n);
}

TEST(Truth, HasTheNormalWhereASquareRootEnds) {
  const Scene scene = scene_of("u", "v", "sqrt(1-u^2-v^2)");
  const auto n = normal_at(scene, {1, 0}, {0.9, 0});
  ASSERT_TRUE(n.has_value());
  // Richardson's steps leave a trillionth: the path comes in along the axis.
  EXPECT_LT(glm::distance(*n, dvec3(1, 0, 0)), 1e-12);
}

TEST(Truth, HasNoNormalWhereThereIsNoLimit) {
  const Scene scene = scene_of("u", "v", "u*sin(1/u)", {"0", "1"});
  EXPECT_FALSE(normal_at(scene, {0, 0}, {0.1, 0.1}).has_value());
}

}  // namespace
}  // namespace saddle
