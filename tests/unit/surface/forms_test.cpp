// Normals and curvatures as formulas, against surfaces whose curvatures are known.
#include "surface/forms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "eval/batch.h"
#include "surface/normal.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Curvatures are quotients of some twenty products of numbers near 1, each right to an ULP.
constexpr double kRounding = 1e-13;

Surface of_second_order(const std::string& x, const std::string& y, const std::string& z,
                        bool flip = false) {
  Surface surface = surface_from_text(x, y, z, {0, 6, -1, 1}, {}, Order::Second);
  surface.flip = flip;
  return surface;
}

std::vector<dvec2> places() {
  std::vector<dvec2> uv;
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 9; ++j) uv.emplace_back(0.05 + 0.5 * i, -0.97 + 0.23 * j);
  }
  return uv;
}

TEST(Curvature, OfASphereIsTheSameInAllDirections) {
  for (const bool flip : {false, true}) {
    const Surface sphere = of_second_order("3*cos(u)*cos(v)", "3*sin(u)*cos(v)", "3*sin(v)", flip);
    for (const Curvature& c : evaluate_curvature(sphere, places())) {
      const double expected = flip ? 1.0 / 3 : -1.0 / 3;  // bends away from its outside
      EXPECT_NEAR(c.gauss, 1.0 / 9, kRounding);
      EXPECT_NEAR(c.mean, expected, kRounding);
      // Also where both are equal: H +- sqrt(H^2 - K) would be off by 1e-8.
      EXPECT_NEAR(c.largest, expected, kRounding);
      EXPECT_NEAR(c.smallest, expected, kRounding);
    }
  }
}

TEST(Curvature, OfATorusIsThatOfItsCircles) {
  const Surface torus = of_second_order("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)");
  const std::vector<dvec2> uv = places();
  const std::vector<Curvature> curvatures = evaluate_curvature(torus, uv);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    const double around = -std::cos(uv[i].y) / (2 + std::cos(uv[i].y));
    EXPECT_NEAR(curvatures[i].largest, around, kRounding);
    EXPECT_NEAR(curvatures[i].smallest, -1, kRounding);
    EXPECT_NEAR(curvatures[i].gauss, -around, kRounding);
    EXPECT_NEAR(curvatures[i].mean, (around - 1) / 2, kRounding);
  }
}

TEST(Curvature, OfAMinimalSurfaceHasNoMean) {
  // A parametrisation that is neither orthogonal nor conformal: the catenoid, sheared in (u, v).
  const Surface catenoid = of_second_order("cosh(v)*cos(u+v)", "cosh(v)*sin(u+v)", "v");
  for (const Curvature& c : evaluate_curvature(catenoid, places())) {
    EXPECT_NEAR(c.mean, 0, kRounding);
    EXPECT_LT(c.gauss, -0.1);
    EXPECT_NEAR(c.largest, -c.smallest, kRounding);
  }
}

TEST(Curvature, SaysWhichWayThePrincipalOnesGo) {
  // Up along v, down along u.
  const dvec2 middle(0, 0);
  const Curvature c =
      evaluate_curvature(of_second_order("u", "v", "v^2-3*u^2/2"), std::span(&middle, 1)).front();
  EXPECT_DOUBLE_EQ(c.largest, 2);
  EXPECT_DOUBLE_EQ(c.smallest, -3);
  EXPECT_EQ(c.r_uu, dvec3(0, 0, -3));
  EXPECT_EQ(c.r_uv, dvec3(0, 0, 0));
  EXPECT_EQ(c.r_vv, dvec3(0, 0, 2));
}

TEST(Curvature, IsUndefinedWhereThereIsNoNormal) {
  const dvec2 apex(1, 0);
  const Curvature c =
      evaluate_curvature(of_second_order("v*cos(u)", "v*sin(u)", "v"), std::span(&apex, 1)).front();
  EXPECT_FALSE(std::isfinite(c.gauss));
  EXPECT_FALSE(std::isfinite(c.mean));
}

TEST(NormalColumns, AreTheNormalFromTheTangents) {
  const Surface surface = surface_from_text("u*cos(v)", "exp(u)*sin(v)", "u^2+v", {});
  std::vector<double> u;
  std::vector<double> v;
  for (const dvec2& place : places()) {
    u.push_back(place.x);
    v.push_back(place.y);
  }
  const NormalColumns columns = evaluate_normals(surface, u, v);
  const std::vector<SurfacePoint> points = evaluate(surface, places());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& p = points[i];
    const dvec3 expected = unit_normal(p, glm::length(p.r_u), glm::length(p.r_v), false).value();
    const double cross = glm::length(glm::cross(p.r_u, p.r_v));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(columns[k][i], p.position[static_cast<int>(k)]);
      EXPECT_NEAR(columns[kNormalColumn + k][i], expected[static_cast<int>(k)], kRounding);
    }
    EXPECT_NEAR(columns[kAreaColumn][i] / cross, 1, kRounding);
    EXPECT_NEAR(columns[kSquareUColumn][i] / glm::dot(p.r_u, p.r_u), 1, kRounding);
    EXPECT_NEAR(columns[kSquareVColumn][i] / glm::dot(p.r_v, p.r_v), 1, kRounding);
  }
}

TEST(NormalOutputs, LeaveOutWhatIsZeroByStructure) {
  Graph graph;
  const NodeId u = graph.variable(kSymbolU);
  const NodeId v = graph.variable(kSymbolV);
  // The plane: its normal is a constant, so nothing is left to compute per point.
  const Tangents tangents = tangents_of(graph, {u, v, graph.constant(0)});
  EXPECT_TRUE(compile(graph, normal_outputs(graph, tangents)).of_both.empty());
}

}  // namespace
}  // namespace saddle
