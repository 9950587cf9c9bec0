// Meshes of surfaces whose range of v has ends that depend on u.
#include <gtest/gtest.h>

#include <cmath>

#include "mesh_checks.h"
#include "scene/model/assignments.h"
#include "scene/options/resolve.h"
#include "study/check_surface.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

CheckedSurface check(const std::vector<std::string>& assignments) {
  Scene scene;
  for (const std::string& assignment : assignments) assign(scene, assignment);
  scene = resolve(scene);
  return check_surface(scene, scene.surfaces.at(0), 1);
}

Tessellation mesh_of(const std::vector<std::string>& assignments) {
  return check(assignments).tessellation;
}

Facts facts_of(const std::vector<std::string>& assignments) {
  return check(assignments).facts;
}

TEST(DependentDomain, HasItsArea) {
  // Under a sine; on a sphere, whose area in latitude and longitude is the integral of cos v.
  EXPECT_NEAR(facts_of({"z=0", "u=0:pi", "v=0:sin(u)"}).measures.area.value, 2, 1e-9);
  const Facts part =
      facts_of({"x=cos(u)*cos(v)", "y=sin(u)*cos(v)", "z=sin(v)", "u=0:2*pi", "v=0:1-u/7"});
  const double area = 7 * (std::cos(1 - 2 * kPi / 7) - std::cos(1.0));
  EXPECT_NEAR(part.measures.area.value, area, 1e-9);
}

TEST(DependentDomain, HasTheUsersParametersExactNormalsAndVerticesOnItsEnds) {
  const Tessellation wave = mesh_of({"z=u*v", "u=0:pi", "v=0:sin(u)"});
  const Mesh& mesh = wave.mesh;
  std::size_t on_sine = 0;
  for (std::size_t k = 0; k < mesh.uv.size(); ++k) {
    const auto [u, v] = std::pair(mesh.uv[k].x, mesh.uv[k].y);
    EXPECT_NEAR(glm::distance(mesh.position[k], dvec3(u, v, u * v)), 0, 1e-15);
    EXPECT_GE(v, 0);
    EXPECT_LE(v, std::sin(u) + 1e-15);
    on_sine += v > 0 && std::fabs(v - std::sin(u)) < 1e-15 ? 1 : 0;
    const dvec3 normal = glm::normalize(dvec3(-v, -u, 1));
    EXPECT_NEAR(glm::distance(mesh.normal[k], normal), 0, 1e-9);
  }
  EXPECT_GE(on_sine, 14U);
  EXPECT_EQ(triangles_against_normals(mesh), 0U);
  EXPECT_LE(wave.report.max_error, *wave.report.tolerance);
}

TEST(DependentDomain, DoesNotJumpWhereRoundingDecidesWhetherItIsDefined) {
  // On the ends of v, where all that is under the root is rounding, 1/0 and ln(0) alike.
  for (const char* z : {"z=sqrt(1-u^2-v^2)", "z=ln(1-u^2-v^2)", "z=1/(1-u^2-v^2)"}) {
    const Tessellation disc = mesh_of({z, "u=-1:1", "v=-sqrt(1-u^2):sqrt(1-u^2)"});
    EXPECT_EQ(disc.report.jump_count, 0U) << z;
  }
}

TEST(DependentDomain, IsAPointWhereItsEndsMeet) {
  const Facts leaf = facts_of({"z=u*v", "u=0:pi", "v=0:sin(u)"});
  EXPECT_EQ(leaf.topology.euler_number, 1);
  EXPECT_EQ(leaf.topology.boundary_loops, 1U);
  for (const SingularPlace& place : leaf.singular) {
    EXPECT_NEAR(place.uv.y, 0, 1e-15);
    EXPECT_TRUE(place.uv.x == 0 || place.uv.x == kPi) << place.uv.x;
  }
}

TEST(DependentDomain, KeepsItsFrontWhereItsEndsChangePlaces) {
  const Mesh mesh = mesh_of({"z=0", "u=0:2*pi", "v=0:sin(u)"}).mesh;
  for (const dvec3& normal : mesh.normal) {
    EXPECT_NEAR(glm::distance(normal, dvec3(0, 0, 1)), 0, 1e-15);
  }
}

TEST(DependentDomain, EndsWhereItsEndsDo) {
  const Tessellation half = mesh_of({"z=u+v", "u=-1:1", "v=0:sqrt(u)"});
  EXPECT_NEAR(half.report.undefined_fraction, 0.5, 1e-9);
  for (const dvec2& uv : half.mesh.uv) {
    EXPECT_GE(uv.x, 0);
    EXPECT_LE(uv.y, std::sqrt(uv.x) + 1e-15);
  }
  ASSERT_EQ(half.warnings.size(), 1U);
  EXPECT_NE(half.warnings[0].find("outside of u = "), std::string::npos) << half.warnings[0];
}

TEST(DependentDomain, JoinsWhereItsEndsAreAPeriodApart) {
  const CheckedSurface tube = check({"x=cos(v)", "y=sin(v)", "z=u", "u=0:1", "v=u:u+2*pi"});
  EXPECT_EQ(tube.tessellation.report.closed_v, "join");
  EXPECT_EQ(tube.facts.topology.euler_number, 0);
}

}  // namespace
}  // namespace saddle
