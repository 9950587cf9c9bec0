#include "surface/normal.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mesh/tree/leaf_mesh.h"
#include "mesh/tree/singular_corners.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();
constexpr double kSettled = 1e-4;  // changes (radians) at which a limit still counts as one
// What the method reaches at singular points whose normals are analytic in the square root of the
// distance: it stops once its changes are below 1e-12, and those bound the error there.
constexpr double kLimitError = 1e-11;

/// Distance of the limit from a vector of any length; huge where there is none.
double limit_error(const Surface& surface, dvec2 corner, dvec2 inside, const dvec3& expected) {
  const NormalLimit limit = limit_normal(surface, corner, inside);
  return limit.normal ? glm::distance(*limit.normal, glm::normalize(expected)) : kInf;
}

Surface sphere(const std::string& radius = "1", const std::string& shift = "0") {
  return surface_from_text("s+r*cos(u)*sin(v)", "s+r*sin(u)*sin(v)", "r*cos(v)-s",
                           {0, 2 * kPi, 0, kPi}, {{"r", radius}, {"s", shift}});
}

Surface double_cone() {
  return surface_from_text("v*cos(u)", "v*sin(u)", "v", {0, 2 * kPi, -1, 1});
}

TEST(UnitNormal, IsTheDirectionOfTheCrossProduct) {
  const SurfacePoint point{{0, 0, 0}, {2, 0, 0}, {1, 3, 0}};
  EXPECT_EQ(unit_normal(point, 2, 4, false), dvec3(0, 0, 1));
  EXPECT_EQ(unit_normal(point, 2, 4, true), dvec3(0, 0, -1));
}

TEST(UnitNormal, IsNothingForParallelTangents) {
  EXPECT_FALSE(unit_normal({{0, 0, 0}, {1, 2, 3}, {2, 4, 6}}, 4, 8, false));
}

TEST(UnitNormal, IsNothingWhereTangentsVanishBesideTheirSurroundings) {
  const SurfacePoint point{{0, 0, 0}, {1e-8, 0, 0}, {0, 1, 0}};
  EXPECT_FALSE(unit_normal(point, 1, 1, false));
  EXPECT_TRUE(unit_normal(point, 1e-8, 1, false));
  EXPECT_FALSE(unit_normal({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, 0, 1, false));
}

TEST(UnitNormal, IsNothingForTangentsThatAreNotFinite) {
  EXPECT_FALSE(unit_normal({{0, 0, 0}, {kNan, 0, 0}, {0, 1, 0}}, 1, 1, false));
  EXPECT_FALSE(unit_normal({{0, 0, 0}, {1, 0, 0}, {0, kInf, 0}}, 1, 1, false));
}

TEST(UnitNormal, SurvivesTangentsWhoseProductsDoNot) {
  for (const double size : {1e200, 1e-200, 5e-324, 1e308}) {
    const SurfacePoint point{{0, 0, 0}, {size, 0, 0}, {0, size, 0}};
    EXPECT_EQ(unit_normal(point, size, size, false), dvec3(0, 0, 1)) << size;
  }
}

TEST(SafeLength, NeitherOverflowsNorVanishes) {
  EXPECT_DOUBLE_EQ(safe_length({3e200, 4e200, 0}), 5e200);
  EXPECT_DOUBLE_EQ(safe_length({0, 3e-200, 4e-200}), 5e-200);
  EXPECT_EQ(safe_length({3, 0, 4}), 5);
  EXPECT_EQ(safe_length({0, 0, 0}), 0);
  EXPECT_EQ(safe_length({1, kNan, 1}), kInf);
  EXPECT_EQ(safe_length({1, -kInf, 1}), kInf);
}

TEST(LimitNormal, AtASpheresPolesIsTheAxis) {
  EXPECT_LT(limit_error(sphere(), {1, 0}, {1.01, 0.01}, {0, 0, -1}), kLimitError);
  EXPECT_LT(limit_error(sphere(), {1, kPi}, {1.01, kPi - 0.01}, {0, 0, 1}), kLimitError);
}

TEST(LimitNormal, WorksOnCoarseAndFineCells) {
  for (const double cell : {0.7, 0.1, 1e-3, 1e-5}) {
    EXPECT_LT(limit_error(sphere(), {1, 0}, {1 + cell, cell}, {0, 0, -1}), kLimitError) << cell;
  }
}

TEST(LimitNormal, DoesNotDependOnSizeOrPlace) {
  for (const char* radius : {"1e-200", "1e-8", "1e8", "1e200"}) {
    EXPECT_LT(limit_error(sphere(radius), {1, 0}, {1.01, 0.01}, {0, 0, -1}), kLimitError) << radius;
  }
  EXPECT_LT(limit_error(sphere("1", "1e7"), {1, 0}, {1.01, 0.01}, {0, 0, -1}), kLimitError);
}

TEST(LimitNormal, AtAConesApexIsThatOfTheRulingAndChangesSignThroughIt) {
  const dvec3 outside(std::cos(1.0), std::sin(1.0), -1);  // r_u x r_v = v (cos u, sin u, -1)
  EXPECT_LT(limit_error(double_cone(), {1, 0}, {1.02, 0.01}, outside), kLimitError);
  EXPECT_LT(limit_error(double_cone(), {1, 0}, {1.02, -0.01}, -outside), kLimitError);
}

TEST(LimitNormal, AtACuspEdgeIsOneSided) {
  const Surface cusp = surface_from_text("u^2", "u^3", "v", {});
  EXPECT_LT(limit_error(cusp, {0, 0.3}, {0.01, 0.31}, {0, -1, 0}), kLimitError);
  EXPECT_LT(limit_error(cusp, {0, 0.3}, {-0.01, 0.31}, {0, 1, 0}), kLimitError);
}

TEST(LimitNormal, AtAWhitneyUmbrellasPinchPointDependsOnTheDirection) {
  const Surface umbrella = surface_from_text("u*v", "u", "v^2", {});
  for (const dvec2 d : {dvec2(0.01, 0.02), dvec2(-0.01, 0.02), dvec2(0.03, -0.01)}) {
    const dvec3 expected(2 * d.y, 0, -d.x);  // r_u x r_v = (2v, -2v^2, -u)
    EXPECT_LT(limit_error(umbrella, {0, 0}, d, expected), kLimitError) << d.x << ' ' << d.y;
  }
}

TEST(LimitNormal, AtASwallowtailsTipIsTheCommonTangentPlanes) {
  // r_u x r_v = (2u + 12v^2) (1, v, v^2).
  const Surface swallowtail = surface_from_text("u*v^2+3*v^4", "-2*u*v-4*v^3", "u", {});
  EXPECT_LT(limit_error(swallowtail, {0, 0}, {0.01, 0.001}, {1, 0, 0}), kLimitError);
  EXPECT_LT(limit_error(swallowtail, {0, 0}, {-0.01, 0.001}, {-1, 0, 0}), kLimitError);
}

TEST(LimitNormal, FindsRemovableQuotients) {
  const Surface sinc = surface_from_text("u", "v", "sin(u)/u", {});
  EXPECT_LT(limit_error(sinc, {0, 0.5}, {0.01, 0.52}, {0, 0, 1}), kLimitError);
  const Surface ripple =
      surface_from_text("u", "v", "sin(sqrt(u^2+v^2))/sqrt(u^2+v^2)", {-10, 10, -10, 10});
  // Its derivative loses 2.2e-16 / r^2 to cancellation, so that the changes stop shrinking early.
  EXPECT_LT(limit_error(ripple, {0, 0}, {0.05, 0.05}, {0, 0, 1}), kSettled);
}

TEST(LimitNormal, FindsTheVerticalTangentAtTheRimOfASquareRoot) {
  const Surface rim = surface_from_text("u", "v", "sqrt(1-u^2)", {});
  EXPECT_LT(limit_error(rim, {1, 0.5}, {0.99, 0.52}, {1, 0, 0}), kLimitError);
}

TEST(LimitNormal, AtAPoleWithACubeRootIsRoughButThere) {
  const Surface pole = surface_from_text("u*cos(v)", "u*sin(v)", "u^(4/3)", {0, 1, 0, 6});
  // Powers of tau that the tableau does not know leave up to three times the last change.
  EXPECT_LT(limit_error(pole, {0, 1}, {0.001, 1.01}, {0, 0, 1}), 3 * kSettled);
}

TEST(LimitNormal, AgreesWithTheNormalOfARegularPoint) {
  const Surface saddle = surface_from_text("u", "v", "u^2-v^2", {});
  EXPECT_LT(limit_error(saddle, {0.5, 0.25}, {0.51, 0.26}, {-1, 0.5, 1}), kLimitError);
}

TEST(LimitNormal, IsTurnedOnAFlippedSurface) {
  Surface flipped = sphere();
  flipped.flip = true;
  EXPECT_LT(limit_error(flipped, {1, 0}, {1.01, 0.01}, {0, 0, 1}), kLimitError);
}

TEST(LimitNormal, IsNothingWhereTheNormalConvergesTooSlowly) {
  const Surface slow = surface_from_text("u", "v", "u*log(u)", {0, 1, 0, 1});
  for (const double cell : {0.1, 1e-2, 1e-3, 1e-6}) {
    EXPECT_FALSE(limit_normal(slow, {0, 0.5}, {cell, 0.5}).normal) << cell;
  }
}

TEST(LimitNormal, IsNothingWhereTheNormalOscillates) {
  for (const char* z : {"u*sin(1/u)", "u^2*sin(1/u)"}) {
    const Surface wild = surface_from_text("u", "v", z, {0, 1, 0, 1});
    EXPECT_FALSE(limit_normal(wild, {0, 0.5}, {0.01, 0.51}).normal) << z;
  }
}

/// r_u x r_v is 0 to second order along v = 0, and the way there ends with rounding errors alone.
TEST(LimitNormal, IsWhatItWasBeforeItsDigitsWereLost) {
  const Surface horns =
      surface_from_text("(2+cos(u))*(v/3-sin(v))", "(2+cos(u-2*pi/3))*(cos(v)-1)",
                        "(2+cos(u+2*pi/3))*(cos(v)-1)", {-kPi, kPi, -2 * kPi, 2 * kPi});
  for (const double u : {-2.5085, -2.0988, -1.0472}) {
    const double a = u - 2 * kPi / 3;
    const double b = u + 2 * kPi / 3;
    const dvec3 normal(0, 2 * std::sin(u) * (2 + std::cos(b)) - (2 + std::cos(u)) * std::sin(b),
                       -2 * std::sin(u) * (2 + std::cos(a)) + (2 + std::cos(u)) * std::sin(a));
    EXPECT_LE(limit_error(horns, {u, 0}, {u + 0.1, 0.13}, normal), 1e-5) << u;
  }
}

TEST(LimitNormal, IsNothingWhereTheInsideIsUndefined) {
  const Surface rim = surface_from_text("u", "v", "sqrt(1-u^2)", {});
  EXPECT_FALSE(limit_normal(rim, {1, 0.5}, {1.01, 0.5}).normal);
}

TEST(LimitNormals, AreThoseOfEachApproach) {
  std::vector<Approach> approaches;
  for (int k = 0; k < 5000; ++k) {  // more than are evaluated in one batch
    approaches.push_back({{0.001 * k, 0}, {0.001 * k + 0.01, k % 2 == 0 ? 0.01 : -0.01}});
  }
  const std::vector<NormalLimit> limits = limit_normals(double_cone(), approaches, 2);
  ASSERT_EQ(limits.size(), approaches.size());
  for (const std::size_t k : {0U, 1U, 4095U, 4096U, 4999U}) {
    const NormalLimit alone =
        limit_normal(double_cone(), approaches[k].corner, approaches[k].inside);
    EXPECT_EQ(limits[k].normal, alone.normal) << k;
  }
}

TEST(LastLimits, AreFoundAnewForOtherCorners) {
  const Surface cone = double_cone();
  const std::vector<Approach> above = {{{0.5, 0}, {0.5, 0.1}}, {{1.5, 0}, {1.5, 0.1}}};
  std::vector<Approach> aside = above;
  aside[1].inside.y = -0.1;
  LastLimits last;
  for (const std::vector<Approach>& approaches : {above, above, aside, above}) {
    const std::vector<NormalLimit> expected = limit_normals(cone, approaches, 1);
    const std::vector<NormalLimit> limits = last.find(cone, approaches, 1);
    ASSERT_EQ(limits.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(limits[k].normal, expected[k].normal) << k;
  }
  EXPECT_TRUE(last.find(cone, {}, 1).empty());
}

}  // namespace
}  // namespace saddle
