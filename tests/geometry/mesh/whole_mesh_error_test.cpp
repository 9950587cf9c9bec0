// The error that a report tells against the true one, where the surface is known without the
// program: plateaus with an upright wall between them, and thin ridges.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>

#include "mesh/mesher/mesher.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult mesh_of(const std::string& z) {
  MeshRequest request = within_share(1e-3);
  request.max_triangles = 200'000;
  return try_mesh(height_field(z.c_str(), {-1, 1, -1, 1}), request).value();
}

/// Plateaus at z = -1 and z = 1. `across`: the signed distance from the wall between them in the
/// plane, positive where z = 1.
struct Wall {
  const char* z;
  std::function<double(dvec2)> across;
  std::function<dvec2(double)> along;  ///< a place on the wall, for 0 to 1
};

class UprightWalls : public ::testing::TestWithParam<Wall> {};

double distance_from_plateaus(const Wall& wall, const dvec3& p) {
  const double across = wall.across(dvec2(p));
  const double from_plateau = across > 0 ? std::fabs(p.z - 1) : std::fabs(p.z + 1);
  return std::min(from_plateau, std::fabs(across));
}

/// The largest distance of wall and mesh, both ways.
double true_error(const Wall& wall, const Mesh& mesh) {
  double error = 0;
  constexpr int kParts = 8;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i <= kParts; ++i) {
      for (int j = 0; i + j <= kParts; ++j) {
        const dvec2 w = dvec2(i, j) / double{kParts};
        const dvec3 p = (1 - w.x - w.y) * mesh.position[t[0]] + w.x * mesh.position[t[1]] +
                        w.y * mesh.position[t[2]];
        error = std::max(error, distance_from_plateaus(wall, p));
      }
    }
  }
  const TriangleTree tree(mesh);
  for (int k = 0; k <= 3000; ++k) {
    for (const double z : {-0.9, -0.5, 0.0, 0.5, 0.9})
      error = std::max(error, tree.distance(dvec3(wall.along(k / 3000.0), z)));
  }
  return error;
}

/// Distances of a mesh that is nowhere near take as long as points of the surface.
TEST(TriangleTree, CountsDistancesAsWork) {
  const Mesh mesh = mesh_of("sin(3*u*v)").mesh;
  const auto count = std::make_shared<PointCount>();
  count->allow(1000);
  const TriangleTree tree(mesh.position, mesh.triangles, 1, count);
  tree.distance(dvec3(0.3, 0.2, 0.1));
  EXPECT_FALSE(count->is_used_up()) << "one distance visits a few nodes";
  for (int k = 0; k < 10'000; ++k) tree.distance(dvec3(1e-4 * k, 0.2, 0.1));
  EXPECT_TRUE(count->is_used_up());
  EXPECT_EQ(count->total(), 0U);
}

TEST_P(UprightWalls, AreToldToBeAsFarOffAsTheyAre) {
  const MeshResult result = mesh_of(GetParam().z);
  const double tolerance = *result.report.tolerance;
  const double error = true_error(GetParam(), result.mesh);
  EXPECT_LE(result.report.max_error, 3 * std::max(error, 0.7 * tolerance)) << error;
  if (error > 1.02 * tolerance) {
    EXPECT_GE(result.report.max_error, error / 3);
  }
}

dvec2 on_circle(double radius, double part) {
  const double angle = 2 * std::numbers::pi * part;
  return radius * dvec2(std::cos(angle), std::sin(angle));
}

INSTANTIATE_TEST_SUITE_P(
    Walls, UprightWalls,
    ::testing::Values(Wall{"tanh(1e12*(u-0.1))", [](dvec2 uv) { return uv.x - 0.1; },
                           [](double part) { return dvec2(0.1, 2 * part - 1); }},
                      Wall{"clamp(1e5*(hypot(u,v)-0.7),-1,1)",
                           [](dvec2 uv) { return glm::length(uv) - 0.7; },
                           [](double part) { return on_circle(0.7, part); }},
                      Wall{"tanh(1e6*(u^2+v^2-0.5))",
                           [](dvec2 uv) { return glm::length(uv) - std::sqrt(0.5); },
                           [](double part) { return on_circle(std::sqrt(0.5), part); }}));

class SteepWalls : public ::testing::TestWithParam<Wall> {};

TEST_P(SteepWalls, AreWithinTheTolerance) {
  const MeshResult result = mesh_of(GetParam().z);
  const double tolerance = *result.report.tolerance;
  ASSERT_LE(result.report.max_error, tolerance);
  // The formulas are within 0.05 tolerances of an upright wall.
  EXPECT_LE(true_error(GetParam(), result.mesh), 1.07 * tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    Walls, SteepWalls,
    ::testing::Values(Wall{"erf(1.73e4*(u^2+v^2-0.4315))",
                           [](dvec2 uv) { return glm::length(uv) - std::sqrt(0.4315); },
                           [](double part) { return on_circle(std::sqrt(0.4315), part); }},
                      Wall{"2/(1+exp(-3.585e4*(u^2+v^2-0.845)))-1",
                           [](dvec2 uv) { return glm::length(uv) - std::sqrt(0.845); },
                           [](double part) { return on_circle(std::sqrt(0.845), part); }},
                      Wall{"clamp(1e5*(u+v),-1,1)",
                           [](dvec2 uv) { return (uv.x + uv.y) / std::numbers::sqrt2; },
                           [](double part) { return dvec2(2 * part - 1, 1 - 2 * part); }}));

/// A ridge of height 1, thinner than the tolerance.
struct Ridge {
  const char* z;
  std::function<dvec2(double)> crest;  ///< for 0 to 1
};

class ThinRidges : public ::testing::TestWithParam<Ridge> {};

TEST_P(ThinRidges, AreToldToBeAsFarOffAsTheyAre) {
  const MeshResult result = mesh_of(GetParam().z);
  const TriangleTree tree(result.mesh);
  double error = 0;
  for (int k = 0; k <= 20'000; ++k)
    error = std::max(error, tree.distance(dvec3(GetParam().crest(k / 20'000.0), 1)));
  ASSERT_GT(error, 10 * *result.report.tolerance);
  EXPECT_GE(result.report.max_error, error / 3);
  EXPECT_LE(result.report.max_error, 1);
}

INSTANTIATE_TEST_SUITE_P(Ridges, ThinRidges,
                         ::testing::Values(Ridge{"exp(-((v-u^2)/1e-5)^2)",
                                                 [](double part) {
                                                   return dvec2(2 * part - 1,
                                                                std::pow(2 * part - 1, 2));
                                                 }},
                                           Ridge{"exp(-((u^2+v^2-0.5)/1e-3)^2)", [](double part) {
                                                   return on_circle(std::sqrt(0.5), part);
                                                 }}));

}  // namespace
}  // namespace saddle
