// What `saddle check` measures and proves, against closed forms.
#include "study/facts.h"
#include "mesh/model/mesh_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/gallery/samples.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

Facts facts_of(const Scene& scene) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  const MeshResult mesh = mesh_of(surface, scene, 1e-3);
  return gather_facts(surface, mesh.mesh, mesh.report, scene.clip.box.has_value(), 1);
}

/// The graph of z over a square.
Scene scene_over_square(const char* z, const Range& side) {
  Scene scene = scene_of("paraboloid");
  SurfaceSpec& spec = scene.surfaces.at(0);
  spec.x = "u";
  spec.y = "v";
  spec.z = z;
  spec.u = spec.v = side;
  return scene;
}

void expect_measures(const Facts& facts, double area, double volume, double share) {
  EXPECT_NEAR(facts.measures.area.value, area, share * area);
  EXPECT_NEAR(facts.measures.volume.value, volume, share * std::fabs(volume));
}

TEST(Facts, AreaAndVolumeOfSmoothClosedSurfacesHaveTwelveDigits) {
  expect_measures(facts_of(scene_of("sphere", {"r=2"})), 16 * kPi, 32 * kPi / 3, 1e-12);
  expect_measures(facts_of(scene_of("torus")), 4 * kPi * kPi * 2 * 0.8, 2 * kPi * kPi * 2 * 0.64,
                  1e-12);
}

TEST(Facts, AreaOfOpenAndOneSidedSurfacesIsThatOfTheFormula) {
  EXPECT_NEAR(facts_of(scene_of("cylinder")).measures.area.value, 4 * kPi, 1e-11);
  const double waist = 1.2 + std::sinh(1.2) * std::cosh(1.2);
  EXPECT_NEAR(facts_of(scene_of("catenoid")).measures.area.value, 2 * kPi * waist, 1e-11);
}

TEST(Facts, AreaIsKnownWhereDerivativesGoToInfinity) {
  const double arc = 0.5 * std::sqrt(5.0) + 0.25 * std::asinh(2.0);  // of a parabola
  const struct {
    std::string z;
    Domain domain;
    double area;
  } cases[] = {
      {"sqrt(u)", {0, 1, 0, 1}, arc},
      {"sqrt(abs(u))", {-1, 1, 0, 1}, 2 * arc},
      {"sqrt(abs(u-0.3))", {0.3, 1.3, 0, 1}, arc},
      {"sqrt(1-u^2)", {-1, 1, 0, 1}, kPi},
      {"sqrt(1-v^2)", {0, 1, 0, 1.3}, kPi / 2},  // a part of which is not defined
  };
  for (const auto& [z, domain, area] : cases) {
    const Surface surface = height_field(z, domain);
    const Integrals found = integrate_domain(surface, dvec3(0), 1, 1);
    EXPECT_NEAR(found.area.value, area, 1e-6 * area) << z;
    EXPECT_LE(found.area.error, 1e-6 * area) << z;  // told with six digits
  }
}

TEST(Facts, TellHowFarOffAnAreaMayBe) {
  const Estimate area = facts_of(scene_over_square("sqrt(1-u^2-v^2)", {"-1", "1"})).measures.area;
  EXPECT_GE(area.error, std::fabs(area.value - 2 * kPi));
  EXPECT_LE(area.error, 0.05 * area.value);
}

TEST(Facts, VolumeIsNegativeWhereTheBackIsOutside) {
  expect_measures(facts_of(scene_of("sphere", {"u=2*pi:0"})), 4 * kPi, -4 * kPi / 3, 1e-12);
}

TEST(Facts, AreaOfWhatIsPartlyUndefinedIsThatOfTheMeshAndBetter) {
  const Scene scene = scene_over_square("0*sqrt(1-u^2-v^2)", {"-1.2", "1.2"});
  EXPECT_NEAR(facts_of(scene).measures.area.value, kPi,
              4e-3 * kPi);  // the rim within the tolerance
}

TEST(Facts, CurvaturesAreThoseOfTheClosedForms) {
  const Measures sphere = facts_of(scene_of("sphere", {"r=2"})).measures;
  EXPECT_NEAR(sphere.gauss.low, 0.25, 1e-9);
  EXPECT_NEAR(sphere.gauss.high, 0.25, 1e-9);
  EXPECT_NEAR(sphere.mean.low, -0.5, 1e-9);  // it bends away from its front
  const Measures torus = facts_of(scene_of("torus")).measures;
  EXPECT_NEAR(torus.gauss.high, 1 / (0.8 * 2.8), 1e-9);
  EXPECT_NEAR(torus.gauss.low, -1 / (0.8 * 1.2), 1e-9);
  EXPECT_NEAR(torus.mean.high, -(1 / 0.8 - 1 / 1.2) / 2, 1e-9);
  const Measures cusp = facts_of(scene_of("pseudosphere")).measures;
  EXPECT_NEAR(cusp.gauss.low, -1, 1e-6);
  EXPECT_NEAR(cusp.gauss.high, -1, 1e-6);
}

TEST(Facts, ExtentsAreTheSurfacesNotTheMeshes) {
  // Tilted, so that no line of the mesh passes through an extreme.
  Scene scene = scene_of("torus");
  SurfaceSpec& spec = scene.surfaces.at(0);
  spec.x = "(2+cos(v))*cos(u+0.3)";
  spec.y = "(2+cos(v))*sin(u+0.3)";
  spec.z = "sin(v+0.7)";
  const Bounds extents = facts_of(scene).measures.extents;
  const dvec3 high(3, 3, 1);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(extents.high[k], high[k], 1e-12) << k;
    EXPECT_NEAR(extents.low[k], -high[k], 1e-12) << k;
  }
}

TEST(Facts, CurvaturesThatGrowTowardAPointStayThoseThatWereFound) {
  const Measures cone = facts_of(scene_of("cone-double")).measures;
  EXPECT_TRUE(std::isfinite(cone.mean.high));
  EXPECT_LT(std::fabs(cone.mean.high), 1e6);
}

TEST(Facts, SingularPlacesHaveTheLimitsOfTheirSides) {
  for (const SingularPlace& pole : facts_of(scene_of("sphere")).singular) {
    ASSERT_EQ(pole.normals.size(), 1U);
    EXPECT_NEAR(glm::distance(pole.normals[0], dvec3(0, 0, pole.uv.y > 0 ? 1 : -1)), 0, 1e-9);
    EXPECT_NEAR(glm::distance(pole.position, pole.normals[0]), 0, 1e-12);
  }
  const Facts edge = facts_of(scene_of("cuspidal-edge"));
  ASSERT_FALSE(edge.singular.empty());
  for (const SingularPlace& place : edge.singular) {
    ASSERT_EQ(place.normals.size(), 2U);  // the sheets are tangent, their fronts opposite
    EXPECT_NEAR(glm::distance(place.normals[0], -place.normals[1]), 0, 1e-9);
  }
}

TEST(Facts, WhereItIsDefinedIsProvedAsFarAsBoxesGo) {
  const auto proved = [](const std::string& z) { return prove_defined(height_field(z), 20000); };
  EXPECT_TRUE(proved("exp(u)*sin(v)").everywhere);
  EXPECT_EQ(proved("exp(u)*sin(v)").yes, 1);
  EXPECT_EQ(proved("sqrt(-1-u*u)").no, 1);
  const DefinedShare half = proved("sqrt(u)");
  EXPECT_FALSE(half.everywhere);
  EXPECT_NEAR(half.no, 0.5, 1e-3);
  EXPECT_NEAR(half.yes, 0.5, 1e-3);
  const DefinedShare disc = proved("sqrt(1-u*u-v*v)");
  EXPECT_LE(disc.yes, kPi / 4);
  EXPECT_GE(disc.yes, kPi / 4 - 0.02);
  EXPECT_LE(disc.no, 1 - kPi / 4);
  EXPECT_FALSE(proved("2*u*v/(u^2+v^2)").everywhere);  // but for a point
}

}  // namespace
}  // namespace saddle
