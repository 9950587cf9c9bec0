// Identities of gallery surfaces with other parameters than their own; those of the surfaces as
// they are stand in table.cpp.
#include <array>
#include <string>

#include "geometry/gallery/forms.h"
#include "geometry/gallery/special_values.h"

namespace saddle {
namespace {

TEST(Gallery, MinimalSurfacesHaveNoMeanCurvatureWhateverTheirParameters) {
  expect_minimal(scene_of("catenoid", {"c=0.4"}));
  expect_minimal(scene_of("helicoid", {"h=2"}));
  expect_minimal(scene_of("catenoid-helicoid", {"t=0.7"}));
  expect_minimal(scene_of("enneper-polar", {"n=2"}));
}

TEST(Gallery, CurvaturesFollowParameters) {
  expect_gauss_curvature(scene_of("pseudosphere", {"a=2"}), -0.25);
  expect_gauss_curvature(scene_of("dini", {"b=0.5"}), -1 / 1.25);
  expect_gauss_curvature(scene_of("sphere", {"r=2"}), 0.25);
}

TEST(Gallery, TangentsOfATractrixAreAllOfOneLengthUpToItsAxis) {
  // Tractrix: the tangent from the curve to its axis has length a = 1.
  for (const SurfacePoint& p : sample(scene_of("pseudosphere"), 16).points) {
    const double radius = std::hypot(p.position.x, p.position.y);
    const double along = std::hypot(p.r_v.x, p.r_v.y);
    EXPECT_NEAR(radius * glm::length(p.r_v), along, 64 * kEpsilon);
  }
}

TEST(Gallery, MinimalSurfacesOfComplexNumbersHaveNoMeanCurvatureWhateverTheirParameters) {
  expect_minimal(scene_of("enneper-order", {"n=1"}));
  expect_minimal(scene_of("enneper-order", {"n=3"}));
  // Bjoerling's formula with a circle as a geodesic: a catenoid.
  expect_minimal(scene_of("catalan-bjorling", {"a(s)=cos(s)", "b(s)=sin(s)", "l(s)=s"}));
}

/// The integral of the squared mean curvature over a closed surface by the midpoint rule.
double willmore_energy(const Scene& scene) {
  constexpr std::size_t kCells = 160;
  double sum = 0;
  for (const Jet& jet : jets(scene, kCells, 0.5, 0.5)) {
    const Forms f = forms(jet);
    const double mean = (f.E * f.N - 2 * f.F * f.M + f.G * f.L) / (2 * f.area_squared);
    sum += mean * mean * std::sqrt(f.area_squared);
  }
  const Domain d = prepare_surface(scene, scene.surfaces.at(0)).surface.domain;
  return sum * (d.u1 - d.u0) * (d.v1 - d.v0) / (kCells * kCells);
}

TEST(Gallery, BoysSurfaceOfBryantAndKusnerBendsTheLeast) {
  // 12 pi: the least of all surfaces with a triple point. The parameters have a pole, beside which
  // the midpoint rule is off by its step's square.
  EXPECT_NEAR(willmore_energy(scene_of("boy-bryant-kusner")), 12 * kPi, 1e-3 * 12 * kPi);
}

TEST(Gallery, LawsonsKleinBottleBendsAsMuchAsItsAreaInTheSphere) {
  // Half a turn times the circumference of an ellipse with half-axes 1 and 2.
  const double area = kPi * 8 * std::comp_ellint_2(std::sqrt(3.0) / 2);
  EXPECT_NEAR(willmore_energy(scene_of("lawson-klein")), area, 1e-9 * area);
}

TEST(Gallery, HopfToriBendAsPinkallFound) {
  // pi times the integral of 1 + k^2 over the curve, whose curvature on the sphere is k.
  constexpr int kSteps = 400;
  double sum = 0;
  for (int step = 0; step < kSteps; ++step) {
    const double u = 2 * kPi * step / kSteps;
    const double s = kPi / 2 + 0.5 * std::sin(3 * u);
    const double s1 = 1.5 * std::cos(3 * u);
    const double s2 = -4.5 * std::sin(3 * u);
    const double speed = std::hypot(s1, std::sin(s));
    const double k = (2 * s1 * s1 * std::cos(s) - std::sin(s) * (s2 - std::sin(s) * std::cos(s))) /
                     (speed * speed * speed);
    sum += (1 + k * k) * speed;
  }
  const double energy = kPi * sum * 2 * kPi / kSteps;
  EXPECT_NEAR(willmore_energy(scene_of("hopf-torus")), energy, 1e-9 * energy);
  EXPECT_NEAR(willmore_energy(scene_of("hopf-torus", {"a=0"})), 2 * kPi * kPi, 1e-9);  // Clifford
}

dvec3 point_of(const std::string& name, double u, double v) {
  const Scene scene = scene_of(name);
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0)).surface;
  return evaluate(surface, std::array{dvec2(u, v)}).at(0).position;
}

TEST(Gallery, GammaHasItsKnownValues) {
  // Of the value: the exponent of e is rounded and up to 60, twice 2^-53 times that.
  constexpr double kTolerance = 4e-14;
  const auto modulus = [](double u, double v) { return point_of("gamma-modulus", u, v).z; };
  for (const double u : {-3.25, -2.5, -0.5, 0.5, 1.0, 2.0, 3.0, 4.0}) {
    const double expected = std::abs(std::tgamma(u));
    EXPECT_NEAR(modulus(u, 0), expected, kTolerance * expected) << u;
  }
  for (const double v : {0.3, 1.0, 2.5}) {
    const double on_half = std::sqrt(kPi / std::cosh(kPi * v));
    const double on_axis = std::sqrt(kPi / (v * std::sinh(kPi * v)));
    EXPECT_NEAR(modulus(0.5, v), on_half, kTolerance * on_half) << v;
    EXPECT_NEAR(modulus(0, v), on_axis, kTolerance * on_axis) << v;
    EXPECT_NEAR(gamma_modulus({0.5, v}), on_half, kTolerance * on_half) << v;
  }
}

TEST(Gallery, ZetaHasItsKnownValues) {
  constexpr double kTolerance = 1e-13;  // of the largest of 48 rounded terms
  const auto modulus = [](double u, double v) { return point_of("zeta-modulus", u, v).z; };
  EXPECT_NEAR(modulus(2, 0), kPi * kPi / 6, kTolerance);
  EXPECT_NEAR(modulus(3, 0), 1.2020569031595942854, kTolerance);
  EXPECT_NEAR(modulus(0.5, 0), 1.4603545088095868129, kTolerance);
  EXPECT_NEAR(std::abs(zeta({2, 0})), kPi * kPi / 6, kTolerance);
  for (const double zero : {14.134725141734693790, 21.022039638771554993, 25.010857580145688763}) {
    EXPECT_NEAR(modulus(0.5, zero), 0, kTolerance) << zero;
  }
}

TEST(Gallery, TheDrumObeysTheWaveEquationBetweenItsFixedEdges) {
  Scene scene = scene_of("fourier-drum");
  const std::string deflection = scene.surfaces.at(0).z;
  const std::string residual = "diff(diff(w,t),t)-diff(diff(w,u),u)-diff(diff(w,v),v)";
  assign(scene, "w=" + deflection);
  assign(scene, "q=" + residual);
  scene.surfaces.at(0).z = "q";
  // 225 modes, whose second derivatives are up to 15^2 times as large.
  for (const SurfacePoint& p : sample(scene, 17).points) EXPECT_NEAR(p.position.z, 0, 1e-12);
  for (const double s : {0.0, 0.7, 2.9}) {
    EXPECT_NEAR(point_of("fourier-drum", s, 0).z, 0, 1e-15);
    EXPECT_NEAR(point_of("fourier-drum", kPi, s).z, 0, 1e-15);
  }
}

}  // namespace
}  // namespace saddle
