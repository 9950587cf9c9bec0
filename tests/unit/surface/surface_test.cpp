#include "surface/surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "surface_from_text.h"

namespace saddle {
namespace {

// sin and cos are right to an ULP, and a value is a sum of at most two products of three of them.
constexpr double kUlps = 8 * 2.2e-16;

void expect_near(const dvec3& actual, const dvec3& expected, double tolerance) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(actual[k], expected[k], tolerance) << "component " << k;
}

Surface torus() {
  return surface_from_text("(2+r*cos(v))*cos(u)", "(2+r*cos(v))*sin(u)", "r*sin(v)", {0, 6, 0, 6},
                           {{"r", "0.5"}});
}

TEST(Surface, GivesPositionsAndExactTangentsOfATorus) {
  const double u = 0.7;
  const double v = 2.1;
  const dvec2 uv(u, v);
  const SurfacePoint point = evaluate(torus(), std::span(&uv, 1)).front();
  const double ring = 2 + 0.5 * std::cos(v);
  expect_near(point.position, {ring * std::cos(u), ring * std::sin(u), 0.5 * std::sin(v)},
              3 * kUlps);
  expect_near(point.r_u, {-ring * std::sin(u), ring * std::cos(u), 0}, 3 * kUlps);
  expect_near(
      point.r_v,
      {-0.5 * std::sin(v) * std::cos(u), -0.5 * std::sin(v) * std::sin(u), 0.5 * std::cos(v)},
      kUlps);
}

// A search compares positions of both kinds, so that a last place may be undefined in the other.
TEST(Surface, PositionsAloneHaveTheBitsOfThoseWithTangents) {
  const Surface half = surface_from_text("u*sin(v)", "cosh(u)^3/v", "sqrt(1-u^2-cos(v)^2)", {});
  for (const Surface& surface : {torus(), half}) {
    std::vector<dvec2> uv;
    for (int k = 0; k < 1000; ++k) uv.emplace_back(std::fmod(0.618 * k, 2) - 1, 0.0031 * k);
    const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
    const std::vector<dvec3> positions = evaluate_positions(surface, uv, 1);
    ASSERT_EQ(positions.size(), points.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
      EXPECT_EQ(std::memcmp(&positions[k], &points[k].position, sizeof(dvec3)), 0) << k;
    }
  }
}

TEST(Surface, CompilesSecondDerivativesOnDemandOnly) {
  EXPECT_TRUE(torus().curvatures.outputs.empty());
}

TEST(Surface, KeepsDomainAndFlip) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  const NodeId v = graph.variable(kSymbolV);
  const Surface surface = make_surface(graph, {u, v, u}, {1, -2, 3, 4}, true);
  EXPECT_TRUE(surface.flip);
  EXPECT_EQ(surface.domain.u0, 1);
  EXPECT_EQ(surface.domain.u1, -2);
}

TEST(Surface, GridHasVOuter) {
  const Surface surface = surface_from_text("u", "v", "0", {});
  const std::vector<double> u = {1, 2, 3};
  const std::vector<double> v = {10, 20};
  const std::vector<SurfacePoint> points = evaluate_on_grid(surface, u, v);
  ASSERT_EQ(points.size(), 6U);
  EXPECT_EQ(points[1].position, dvec3(2, 10, 0));
  EXPECT_EQ(points[5].position, dvec3(3, 20, 0));
  EXPECT_EQ(points[5].r_u, dvec3(1, 0, 0));
  EXPECT_EQ(points[5].r_v, dvec3(0, 1, 0));
}

TEST(Surface, GridAndPointsHaveTheSameBitsAcrossBlocks) {
  const Surface surface = torus();
  std::vector<double> u(301);
  std::vector<double> v(151);  // 45451 points: several blocks, the last one not full
  for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.02 * static_cast<double>(i);
  for (std::size_t j = 0; j < v.size(); ++j) v[j] = 0.04 * static_cast<double>(j);
  std::vector<dvec2> uv;
  for (const double b : v) {
    for (const double a : u) uv.emplace_back(a, b);
  }
  const std::vector<SurfacePoint> grid = evaluate_on_grid(surface, u, v, 3);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  ASSERT_EQ(grid.size(), points.size());
  EXPECT_EQ(std::memcmp(grid.data(), points.data(), grid.size() * sizeof(SurfacePoint)), 0);
}

TEST(Surface, ManyPointsAreTheSameAsOneAtATime) {
  const Surface surface = torus();
  std::vector<dvec2> uv;
  for (int k = 0; k < 40000; ++k) uv.emplace_back(1e-4 * k, 6 - 1e-4 * k);
  const std::vector<SurfacePoint> points = evaluate(surface, uv);
  for (const std::size_t k : {0U, 16383U, 16384U, 39999U}) {
    const SurfacePoint alone = evaluate(surface, std::span(&uv[k], 1)).front();
    EXPECT_EQ(points[k].position, alone.position) << k;
    EXPECT_EQ(points[k].r_v, alone.r_v) << k;
  }
}

TEST(Surface, NoPointsGiveNoPoints) {
  EXPECT_TRUE(evaluate(torus(), {}).empty());
  EXPECT_TRUE(evaluate_on_grid(torus(), {}, {}).empty());
}

TEST(Surface, UndefinedIsNotANumber) {
  const Surface surface = surface_from_text("u", "v", "sqrt(u)", {});
  const dvec2 uv(-1, 0);
  const SurfacePoint point = evaluate(surface, std::span(&uv, 1)).front();
  EXPECT_TRUE(std::isnan(point.position.z));
  EXPECT_EQ(point.position.x, -1);
}

}  // namespace
}  // namespace saddle
