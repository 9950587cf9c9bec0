// What `saddle check` measures and proves, against closed forms.
#include "study/facts.h"
#include "mesh/model/mesh_report.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "geometry/gallery/samples.h"
#include "mesh/features/singular_in_space.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

Facts facts_of(const Scene& scene) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  const MeshResult mesh = mesh_of(surface, scene, 1e-3);
  return gather_facts(surface, mesh.mesh, mesh.report, scene.clip.box.has_value(), 1);
}

/// The graph of z over a square.
Scene scene_over_square(const std::string& z, const Range& side) {
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

TEST(Facts, AreaHasSixDigitsUpToARimWhereDerivativesGoToInfinity) {
  for (const char* const side : {"1", "1.2"}) {
    const Range range = {"-" + std::string(side), side};
    const Estimate area = facts_of(scene_over_square("sqrt(1-u^2-v^2)", range)).measures.area;
    EXPECT_NEAR(area.value, 2 * kPi, 1e-6);
    EXPECT_GE(area.error, std::fabs(area.value - 2 * kPi));
    EXPECT_LE(area.error, 1e-5);
  }
  const Estimate ring =
      facts_of(scene_over_square("0*sqrt(u^2+v^2-.25)", {"-1", "1"})).measures.area;
  EXPECT_NEAR(ring.value, 4 - kPi / 4, 1e-6);
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

/// A surface from formulas over a rectangle.
Scene scene_over(const std::array<std::string, 3>& r, const Range& u, const Range& v) {
  Scene scene = scene_over_square(r[2], u);
  SurfaceSpec& spec = scene.surfaces.at(0);
  spec.x = r[0];
  spec.y = r[1];
  spec.v = v;
  return scene;
}

const Range kTurn = {"0", "2*pi"};

/// A torus of radii 2 and 1 with something added to its height.
Scene torus_with(const std::string& height) {
  const std::string z = "sin(v)+" + height;
  return scene_over({"(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", z}, kTurn, kTurn);
}

void expect_within(double x, double expected) {
  EXPECT_NEAR(x, expected, 1e-6 * std::fabs(expected));
}

void expect_bounds(const ValueRange& range) {
  EXPECT_LE(range.bounds.low, range.low);
  EXPECT_GE(range.bounds.high, range.high);
}

/// Of exp(-a r^2) the Gauss curvature at the peak is the square of 2 a, the mean one -2 a.
TEST(Facts, CurvaturesOfNarrowPeaksAreFoundBetweenTheMeshsVertices) {
  for (const double a : {1e6, 1e9}) {
    const std::string z = "exp(-" + std::to_string(a) + "*((u-.312)^2+(v-.17)^2))";
    const Measures peak = facts_of(scene_over_square(z, {"-1", "1"})).measures;
    expect_within(peak.gauss.high, 4 * a * a);
    expect_within(peak.mean.low, -2 * a);
    EXPECT_TRUE(std::isfinite(peak.gauss.bounds.high));
    expect_bounds(peak.gauss);
    expect_bounds(peak.mean);
  }
}

TEST(Facts, BoundsHoldTheCurvaturesOfTheClosedForms) {
  for (const char* const name : {"torus", "catenoid", "helicoid", "monkey-saddle"}) {
    const Measures measures = facts_of(scene_of(name)).measures;
    expect_bounds(measures.gauss);
    expect_bounds(measures.mean);
    EXPECT_TRUE(std::isfinite(measures.gauss.bounds.low)) << name;
    for (int k = 0; k < 3; ++k) {
      EXPECT_LE(measures.extents_bounds.low[k], measures.extents.low[k]) << name;
      EXPECT_GE(measures.extents_bounds.high[k], measures.extents.high[k]) << name;
    }
  }
  const Measures flat = facts_of(scene_over_square("2*u+3*v", {"-1", "1"})).measures;
  EXPECT_EQ(flat.gauss.bounds.low, 0);
  EXPECT_EQ(flat.gauss.bounds.high, 0);
}

TEST(Facts, CurvaturesWithoutABoundAreInfiniteAndHaveAPlace) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Measures cone =
      facts_of(scene_over({"v*cos(u)", "v*sin(u)", "v"}, kTurn, {"0", "1"})).measures;
  const bool falls = cone.mean.falls_toward.has_value();
  ASSERT_NE(falls, cone.mean.grows_toward.has_value());
  EXPECT_EQ(falls ? cone.mean.low : cone.mean.high, falls ? -infinity : infinity);
  EXPECT_NEAR((falls ? cone.mean.falls_toward : cone.mean.grows_toward)->y, 0, 1e-6);
  EXPECT_NEAR(std::fabs(falls ? cone.mean.high : cone.mean.low), std::sqrt(0.125), 1e-9);
  EXPECT_NEAR(cone.gauss.high - cone.gauss.low, 0, 1e-9);
  EXPECT_FALSE(cone.gauss.falls_toward || cone.gauss.grows_toward);
  const Measures spindle =
      facts_of(scene_over({"(1+2*cos(v))*cos(u)", "(1+2*cos(v))*sin(u)", "2*sin(v)"}, kTurn, kTurn))
          .measures;
  EXPECT_TRUE(spindle.gauss.falls_toward && spindle.gauss.grows_toward);
  const Measures edge = facts_of(scene_over_square("abs(u)^1.5", {"-1", "1"})).measures;
  ASSERT_TRUE(edge.mean.grows_toward);
  EXPECT_NEAR(edge.mean.grows_toward->x, 0, 1e-6);
  const Measures slow = facts_of(scene_over_square("(u^2+v^2)*ln(u^2+v^2)", {"-1", "1"})).measures;
  EXPECT_TRUE(slow.mean.falls_toward) << "the logarithm diverges, too";
}

TEST(Facts, CurvaturesWithLimitsAtSingularPointsAreBounded) {
  for (const char* const name : {"sphere", "pseudosphere"}) {
    const Measures measures = facts_of(scene_of(name)).measures;
    EXPECT_FALSE(measures.gauss.falls_toward || measures.gauss.grows_toward) << name;
  }
  const Measures dome = facts_of(scene_over_square("sqrt(1-u^2-v^2)", {"-1", "1"})).measures;
  EXPECT_NEAR(dome.gauss.low, 1, 1e-6);
  EXPECT_NEAR(dome.gauss.high, 1, 1e-6);
  EXPECT_FALSE(dome.mean.falls_toward || dome.mean.grows_toward);
}

/// The mesh ends before the line u = 0, toward which heights and areas grow without end.
TEST(Facts, BesidePolesAreThoseOfTheMesh) {
  const Scene scene = scene_over_square("1/u", {"-1", "1"});
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  const MeshResult mesh = mesh_of(surface, scene, 1e-3);
  ASSERT_GT(mesh.report.pole_count, 0U);
  const Measures measures = gather_facts(surface, mesh.mesh, mesh.report, false, 1).measures;
  EXPECT_EQ(measures.extents.low, mesh.mesh.bounds.low);
  EXPECT_EQ(measures.extents.high, mesh.mesh.bounds.high);
  EXPECT_EQ(measures.extents_bounds.high, mesh.mesh.bounds.high);
  double area = 0;
  for (const Triangle& t : mesh.mesh.triangles) {
    const auto corner = [&](int k) { return mesh.mesh.position[t[static_cast<std::size_t>(k)]]; };
    area += 0.5 * glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
  }
  EXPECT_NEAR(measures.area.value, area, 1e-2 * area);
}

TEST(Facts, AHoleBetweenTheMeshsSamplesCountsAgainstClosed) {
  EXPECT_EQ(facts_of(torus_with("0")).closed, Closed::Yes);
  for (const char* const radius : {"0.5", "1e-3", "1e-5"}) {
    const std::string hole = "0*sqrt((u-1)^2+(v-1)^2-(" + std::string(radius) + ")^2)";
    const Facts facts = facts_of(torus_with(hole));
    EXPECT_EQ(facts.closed, Closed::No) << radius;
    ASSERT_TRUE(facts.defined.undefined_at) << radius;
    // Its middle is named, to a hundredth of the radius.
    EXPECT_LE(glm::distance(*facts.defined.undefined_at, dvec2(1)), 0.01 * std::stod(radius));
  }
  // Undefined at a single point, which no box shows.
  EXPECT_NE(facts_of(torus_with("0*ln((u-1)^2+(v-1)^2)")).closed, Closed::Yes);
  // A disc of the surface is moved away.
  EXPECT_NE(facts_of(torus_with("0.2*(hypot(u-1,v-1)<1e-3)")).closed, Closed::Yes);
}

/// The singular points of space that a surface has, and whether each is on no curve of them.
std::vector<SingularInSpace> singular_points_of(const Scene& scene) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  const MeshResult mesh = mesh_of(surface, scene, 1e-3);
  return singular_in_space(surface, mesh.mesh, mesh.report);
}

TEST(Facts, SingularPlacesAreToldApartFromPointsOfSpace) {
  const auto sphere = singular_points_of(scene_of("sphere"));
  ASSERT_EQ(sphere.size(), 2U);
  EXPECT_TRUE(sphere[0].is_isolated && sphere[1].is_isolated);
  EXPECT_NEAR(std::fabs(sphere[0].position.z), 1, 1e-12);
  EXPECT_EQ(singular_points_of(scene_of("cone-double")).size(), 1U);
  EXPECT_EQ(singular_points_of(scene_of("whitney-umbrella")).size(), 1U);
  EXPECT_EQ(singular_points_of(scene_of("torus")).size(), 0U);
  for (const SingularInSpace& point : singular_points_of(scene_of("cuspidal-edge"))) {
    EXPECT_FALSE(point.is_isolated);
  }
}

TEST(Facts, SheetsThatTouchInAPointArePinched) {
  const Facts spindle = facts_of(
      scene_over({"(1+2*cos(v))*cos(u)", "(1+2*cos(v))*sin(u)", "2*sin(v)"}, kTurn, kTurn));
  EXPECT_EQ(spindle.topology.pinched_points, 2U);
  EXPECT_EQ(facts_of(scene_of("cone-double")).topology.pinched_points, 1U);
  EXPECT_EQ(facts_of(scene_of("torus")).topology.pinched_points, 0U);
  EXPECT_EQ(facts_of(scene_of("klein-bottle")).topology.pinched_points, 0U);
}

TEST(Facts, VolumeIsThatOfTheOutsideWhereFrontAndBackChangePlaces) {
  // Longitudes up to pi, and latitudes all around: the front is outside on one half.
  const Facts sphere = facts_of(
      scene_over({"2*cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)+9"}, {"0", "pi"}, {"0", "2*pi"}));
  EXPECT_TRUE(sphere.turns_over);
  const Estimate volume = sphere.measures.volume;  // of its triangles
  EXPECT_NEAR(volume.value, 8 * kPi / 3, volume.error);
  EXPECT_LT(volume.error, 0.03);
  EXPECT_FALSE(facts_of(scene_of("sphere")).turns_over);
  EXPECT_FALSE(facts_of(scene_of("klein-bottle")).topology.orientable);
}

/// The edge u=0 is a segment there and back: two seams fit it, and one of them is a crease.
TEST(Facts, ASeamThatFitsBothWaysIsTheSmoothOne) {
  const Facts cross_cap =
      facts_of(scene_over({"sin(u)*sin(2*v)/2", "sin(2*u)*cos(v)^2", "cos(2*u)*cos(v)^2"},
                          {"0", "pi"}, {"-pi/2", "pi/2"}));
  EXPECT_FALSE(cross_cap.topology.orientable);
  EXPECT_EQ(cross_cap.topology.euler_number, 1);
  EXPECT_EQ(cross_cap.closed, Closed::Yes);
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
