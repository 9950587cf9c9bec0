// Derivatives and curvatures of gallery surfaces from their formulas, for the tests about them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "eval/batch.h"
#include "formula/derive.h"
#include "formula/scope.h"
#include "geometry/gallery/samples.h"
#include "scene/model/surface_scope.h"

namespace saddle {

inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// Derivatives up to the second at one point.
struct Jet {
  dvec3 u, v, uu, uv, vv;
};

/// Derivatives of a surface at `count`^2 points inside of its domain, evenly spaced, where it is
/// defined; `off_u`, `off_v`: their places in the cells, 0 to 1. The usual ones are off its
/// symmetric lines.
inline std::vector<Jet> jets(const Scene& scene, std::size_t count = 13, double off_u = 0.37,
                             double off_v = 0.59) {
  Graph graph;
  const SurfaceSpec& spec = scene.surfaces.at(0);
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
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
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t i = 0; i < count * count; ++i) {
    u.push_back(d.u0 + (d.u1 - d.u0) * (double(i % count) + off_u) / double(count));
    v.push_back(d.v0 + (d.v1 - d.v0) * (double(i / count) + off_v) / double(count));
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
inline constexpr double kRoundedOperations = 500;

inline Forms forms(const Jet& j) {
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
  f.rounding = kRoundedOperations * kEpsilon * glm::length(j.u) * glm::length(j.v) / area;
  return f;
}

inline void expect_minimal(const Scene& scene) {
  for (const Jet& jet : jets(scene)) {
    const Forms f = forms(jet);
    const double twice_h = f.E * f.N - 2 * f.F * f.M + f.G * f.L;  // times the area squared
    EXPECT_LE(std::abs(twice_h), f.rounding * f.second_size * (f.E + f.G)) << scene.title;
  }
}

inline void expect_gauss_curvature(const Scene& scene, double expected) {
  for (const Jet& jet : jets(scene)) {
    const Forms f = forms(jet);
    EXPECT_NEAR(f.L * f.N - f.M * f.M, expected * f.area_squared,
                f.rounding * (f.second_size * f.second_size + std::abs(expected) * f.E * f.G))
        << scene.title;
  }
}

}  // namespace saddle
