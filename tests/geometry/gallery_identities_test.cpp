// Gallery surfaces against their equations and curvature identities.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "eval/batch.h"
#include "formula/derive.h"
#include "formula/scope.h"
#include "geometry/gallery_samples.h"

namespace saddle {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Derivatives up to the second at one point.
struct Jet {
  dvec3 u, v, uu, uv, vv;
};

/// Derivatives of a surface at points inside of its domain where it is defined, off its symmetric
/// lines.
std::vector<Jet> jets(const Scene& scene) {
  Graph graph;
  std::vector<Definition> names = scene.definitions;
  const SurfaceSpec& spec = scene.surfaces.at(0);
  names.insert(names.end(), {{"x", spec.x}, {"y", spec.y}, {"z", spec.z}});
  Scope scope(graph, names);
  const std::array<NodeId, 3> xyz = {scope.node("x"), scope.node("y"), scope.node("z")};
  const std::vector<NodeId> r = scope.bind(xyz, scene.t);
  const auto by_u = derive(graph, r, kSymbolU);
  const auto by_v = derive(graph, r, kSymbolV);
  std::vector<NodeId> outputs;
  for (const auto& part : {by_u, by_v, derive(graph, by_u, kSymbolU), derive(graph, by_u, kSymbolV),
                           derive(graph, by_v, kSymbolV)}) {
    outputs.insert(outputs.end(), part.begin(), part.end());
  }
  const Tape tape = compile(graph, outputs);

  const Domain d = prepare_surface(scene, spec).surface.domain;
  constexpr std::size_t kCount = 13;
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t i = 0; i < kCount * kCount; ++i) {
    u.push_back(d.u0 + (d.u1 - d.u0) * (double(i % kCount) + 0.37) / kCount);
    v.push_back(d.v0 + (d.v1 - d.v0) * (double(i / kCount) + 0.59) / kCount);
  }
  std::vector<std::vector<double>> columns(outputs.size(), std::vector<double>(u.size()));
  std::vector<double*> starts;
  for (auto& column : columns) starts.push_back(column.data());
  evaluate_points(tape, u, v, starts);

  std::vector<Jet> result;
  for (std::size_t i = 0; i < u.size(); ++i) {
    const auto triple = [&](std::size_t k) {
      return dvec3{columns[k][i], columns[k + 1][i], columns[k + 2][i]};
    };
    const Jet jet{triple(0), triple(3), triple(6), triple(9), triple(12)};
    if (is_finite(jet.u + jet.v + jet.uu + jet.uv + jet.vv)) result.push_back(jet);
  }
  EXPECT_GT(result.size(), u.size() / 5) << scene.title;
  return result;
}

/// The fundamental forms at a regular point.
struct Forms {
  double E, F, G, L, M, N;
  double area_squared;  // E G - F^2
  double second_size;   // bound of |L|, |M|, |N|
  double rounding;      // relative error of L, M, N that rounding explains
};

/// Each entry of a jet comes from some hundred operations.
constexpr double kOperations = 500;

Forms forms(const Jet& j) {
  const dvec3 cross = glm::cross(j.u, j.v);
  const double area = glm::length(cross);
  const dvec3 n = cross / area;
  Forms f{};
  f.E = glm::dot(j.u, j.u);
  f.F = glm::dot(j.u, j.v);
  f.G = glm::dot(j.v, j.v);
  f.L = glm::dot(j.uu, n);
  f.M = glm::dot(j.uv, n);
  f.N = glm::dot(j.vv, n);
  f.area_squared = area * area;
  f.second_size = glm::length(j.uu) + glm::length(j.uv) + glm::length(j.vv);
  // The cross product cancels where the tangents are nearly parallel.
  f.rounding = kOperations * kEpsilon * glm::length(j.u) * glm::length(j.v) / area;
  return f;
}

void expect_minimal(const Scene& scene) {
  for (const Jet& jet : jets(scene)) {
    const Forms f = forms(jet);
    const double twice_h = f.E * f.N - 2 * f.F * f.M + f.G * f.L;  // times the area squared
    EXPECT_LE(std::abs(twice_h), f.rounding * f.second_size * (f.E + f.G)) << scene.title;
  }
}

TEST(Gallery, MinimalSurfacesHaveNoMeanCurvature) {
  for (const char* name : {"catenoid", "helicoid", "catenoid-helicoid", "enneper", "enneper-polar",
                           "scherk-1", "scherk-1-chequerboard", "scherk-2", "scherk-2-tower",
                           "henneberg", "catalan", "bour", "costa"}) {
    expect_minimal(scene_of(name));
  }
  expect_minimal(scene_of("catenoid", {"c=0.4"}));
  expect_minimal(scene_of("helicoid", {"h=2"}));
  expect_minimal(scene_of("catenoid-helicoid", {"t=0.7"}));
  expect_minimal(scene_of("enneper-polar", {"n=2"}));
}

void expect_gauss_curvature(const Scene& scene, double expected) {
  for (const Jet& jet : jets(scene)) {
    const Forms f = forms(jet);
    EXPECT_NEAR(f.L * f.N - f.M * f.M, expected * f.area_squared,
                f.rounding * (f.second_size * f.second_size + std::abs(expected) * f.E * f.G))
        << scene.title;
  }
}

TEST(Gallery, PseudosphericalSurfacesHaveTheirConstantCurvature) {
  expect_gauss_curvature(scene_of("pseudosphere"), -1);
  expect_gauss_curvature(scene_of("pseudosphere", {"a=2"}), -0.25);
  expect_gauss_curvature(scene_of("dini"), -1 / 1.04);
  expect_gauss_curvature(scene_of("dini", {"b=0.5"}), -1 / 1.25);
  expect_gauss_curvature(scene_of("kuen"), -1);
  expect_gauss_curvature(scene_of("kuen-log"), -1);
  expect_gauss_curvature(scene_of("sphere", {"r=2"}), 0.25);
  expect_gauss_curvature(scene_of("cylinder"), 0);
  expect_gauss_curvature(scene_of("cone-double"), 0);
}

double square(double a) {
  return a * a;
}

/// Expects that `equation` is 0 on the surface. `size` bounds the sum of its terms' absolute values
/// where the point is at distance `r` of the origin.
void expect_equation(const Scene& scene, const std::function<double(dvec3)>& equation,
                     const std::function<double(double)>& size) {
  for (const SurfacePoint& p : sample(scene, 16).points) {
    const double r = glm::length(p.position);
    EXPECT_LE(std::abs(equation(p.position)), 64 * kEpsilon * size(r)) << scene.title;
  }
}

/// The same for a polynomial: the sum of its coefficients' absolute values, and its degree.
void expect_polynomial(const Scene& scene, double coefficients, int degree,
                       const std::function<double(dvec3)>& equation) {
  expect_equation(scene, equation,
                  [=](double r) { return coefficients * std::pow(std::max(r, 1.0), degree); });
}

TEST(Gallery, QuadricsFulfilTheirEquations) {
  expect_polynomial(scene_of("sphere", {"r=3"}), 12, 2, [](dvec3 p) { return glm::dot(p, p) - 9; });
  expect_polynomial(scene_of("ellipsoid"), 4, 2,
                    [](dvec3 p) { return square(p.x / 3) + square(p.y / 2) + square(p.z) - 1; });
  expect_polynomial(scene_of("cylinder"), 3, 2, [](dvec3 p) { return p.x * p.x + p.y * p.y - 1; });
  expect_polynomial(scene_of("cone-double", {"h=2"}), 9, 2,
                    [](dvec3 p) { return 4 * (p.x * p.x + p.y * p.y) - p.z * p.z; });
  expect_polynomial(scene_of("hyperboloid-1"), 4, 2,
                    [](dvec3 p) { return p.x * p.x + p.y * p.y - p.z * p.z - 1; });
  expect_polynomial(scene_of("paraboloid"), 3, 2,
                    [](dvec3 p) { return p.x * p.x + p.y * p.y - p.z; });
  expect_polynomial(scene_of("hyperbolic-paraboloid"), 3, 2,
                    [](dvec3 p) { return p.x * p.x - p.y * p.y - p.z; });
}

TEST(Gallery, ToriFulfilTheirEquation) {
  const auto torus = [](double R, double r) {
    return [=](dvec3 p) {
      return square(glm::dot(p, p) + R * R - r * r) - 4 * R * R * (p.x * p.x + p.y * p.y);
    };
  };
  expect_polynomial(scene_of("torus"), 80, 4, torus(2, 0.8));
  expect_polynomial(scene_of("horn-torus"), 24, 4, torus(1, 1));
  expect_polynomial(scene_of("spindle-torus"), 24, 4, torus(0.6, 1));
}

TEST(Gallery, SingularSurfacesFulfilTheirEquations) {
  expect_polynomial(scene_of("whitney-umbrella"), 2, 3,
                    [](dvec3 p) { return p.x * p.x - p.y * p.y * p.z; });
  expect_polynomial(scene_of("cuspidal-edge"), 2, 3,
                    [](dvec3 p) { return p.y * p.y * p.y - p.z * p.z; });
  // The discriminant of t^4 + z t^2 + y t + x.
  expect_polynomial(scene_of("swallowtail"), 575, 5, [](dvec3 p) {
    const double y2 = p.y * p.y;
    const double z2 = p.z * p.z;
    return 16 * z2 * z2 * p.x - 4 * z2 * p.z * y2 - 128 * z2 * p.x * p.x + 144 * p.z * y2 * p.x -
           27 * y2 * y2 + 256 * p.x * p.x * p.x;
  });
  expect_polynomial(scene_of("plucker-conoid"), 4, 3,
                    [](dvec3 p) { return p.z * (p.x * p.x + p.y * p.y) - 2 * p.x * p.y; });
  expect_polynomial(scene_of("hyperboloid-2"), 4, 2,
                    [](dvec3 p) { return p.z * p.z - p.x * p.x - p.y * p.y - 1; });
  expect_polynomial(scene_of("plucker-conoid-cartesian"), 4, 3,
                    [](dvec3 p) { return p.z * (p.x * p.x + p.y * p.y) - 2 * p.x * p.y; });
  expect_polynomial(scene_of("wallis-conical-edge", {"a=2"}), 7, 4, [](dvec3 p) {
    return p.z * p.z * (p.x * p.x + p.y * p.y) - 0.25 * (3 * p.x * p.x + 4 * p.y * p.y);
  });
  expect_polynomial(scene_of("riemann-sqrt"), 7, 4,
                    [](dvec3 p) { return square(2 * p.z * p.z - p.x) - p.x * p.x - p.y * p.y; });
  expect_polynomial(scene_of("riemann-cbrt"), 150, 9, [](dvec3 p) {
    const double left = 4 * p.z * p.z * p.z - p.x;
    return left * left * left - 27 * p.z * p.z * p.z * (p.x * p.x + p.y * p.y);
  });
  expect_polynomial(scene_of("superellipsoid-star"), 28, 6, [](dvec3 p) {
    // |x|^(2/3) + |y|^(2/3) + |z|^(2/3) = 1, without roots.
    const double s = std::cbrt(p.x * p.x) + std::cbrt(p.y * p.y) + std::cbrt(p.z * p.z);
    return s - 1;
  });
  expect_polynomial(scene_of("superellipsoid"), 3, 10, [](dvec3 p) {
    return std::pow(p.x, 10) + std::pow(p.y, 10) + std::pow(p.z, 10) - 1;
  });
  expect_polynomial(scene_of("supertoroid", {"e=0.5"}), 9, 8, [](dvec3 p) {
    const double distance = std::pow(std::pow(p.x, 4) + std::pow(p.y, 4), 0.25) - 2;
    return std::pow(distance, 4) + std::pow(p.z, 4) - std::pow(0.7, 4);
  });
  expect_polynomial(scene_of("spherical-harmonic"), 5, 5, [](dvec3 p) {
    return std::pow(glm::dot(p, p), 2.5) - std::abs(p.z * p.x * (p.x * p.x - 3 * p.y * p.y));
  });
  expect_polynomial(scene_of("monkey-saddle"), 5, 3,
                    [](dvec3 p) { return p.z - p.x * p.x * p.x + 3 * p.x * p.y * p.y; });
  expect_polynomial(scene_of("menn"), 3.5, 4, [](dvec3 p) {
    return p.z - 0.5 * square(p.x * p.x) - p.x * p.x * p.y + p.y * p.y;
  });
  expect_polynomial(scene_of("eight-surface"), 10, 4, [](dvec3 p) {
    return p.x * p.x + p.y * p.y - 4 * p.z * p.z * (1 - p.z * p.z);
  });
  expect_polynomial(scene_of("pillow"), 8, 4,
                    [](dvec3 p) { return 4 * p.z * p.z - (1 - p.x * p.x) * (1 - p.y * p.y); });
  expect_polynomial(scene_of("gabriel-horn"), 3, 4,
                    [](dvec3 p) { return p.x * p.x * (p.y * p.y + p.z * p.z) - 1; });
}

TEST(Gallery, OneSidedSurfacesFulfilTheirEquations) {
  expect_polynomial(scene_of("mobius"), 10, 3, [](dvec3 p) {
    return p.y * (glm::dot(p, p) - 1) - 2 * p.z * (p.x + p.x * p.x + p.y * p.y);
  });
  expect_polynomial(scene_of("roman"), 4, 4, [](dvec3 p) {
    return square(p.x * p.y) + square(p.y * p.z) + square(p.z * p.x) - p.x * p.y * p.z;
  });
}

TEST(Gallery, TranscendentalSurfacesFulfilTheirEquations) {
  const auto exponential = [](double r) { return std::exp(r) * (1 + r); };
  expect_equation(
      scene_of("catenoid"), [](dvec3 p) { return p.x * p.x + p.y * p.y - square(std::cosh(p.z)); },
      [](double r) { return square(std::exp(r)); });
  expect_equation(
      scene_of("helicoid"),
      [](dvec3 p) { return p.y * std::cos(2 * p.z) - p.x * std::sin(2 * p.z); },
      [](double r) { return 1 + 2 * r * r; });
  expect_equation(
      scene_of("scherk-1"), [](dvec3 p) { return std::exp(p.z) * std::cos(p.x) - std::cos(p.y); },
      exponential);
  expect_equation(
      scene_of("scherk-2"), [](dvec3 p) { return std::sin(p.z) - std::sinh(p.x) * std::sinh(p.y); },
      exponential);
  expect_equation(
      scene_of("funnel", {"v=0.01:2"}),
      [](dvec3 p) { return p.z - std::log(p.x * p.x + p.y * p.y) / 2; },
      [](double r) { return 1 + r; });
  // Tractrix: the tangent from the curve to its axis has length a = 1.
  for (const SurfacePoint& p : sample(scene_of("pseudosphere"), 16).points) {
    const double radius = std::hypot(p.position.x, p.position.y);
    const double along = std::hypot(p.r_v.x, p.r_v.y);
    EXPECT_NEAR(radius * glm::length(p.r_v), along, 64 * kEpsilon);
  }
}

}  // namespace
}  // namespace saddle
