// Meshes with exact positions and normals, made by hand: the tests of drawing depend on no formula.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include "mesh/model/mesh.h"

namespace saddle {

/// A point of a surface and its unit normal.
struct AnalyticPoint {
  dvec3 position;
  dvec3 normal;
};

/// Cells in u and v, and every how many cells a line is drawn (0: none).
struct AnalyticGrid {
  std::uint32_t cells_u = 64;
  std::uint32_t cells_v = 64;
  std::uint32_t line_every = 0;
};

/// The grid of `surface`(s, t), s and t in [0, 1]; the normal points out of r_s x r_t.
template <typename Surface>
Mesh analytic_mesh(const Surface& surface, const AnalyticGrid& grid = {}) {
  Mesh mesh;
  const std::uint32_t columns = grid.cells_u + 1;
  const auto corner = [columns](std::uint32_t i, std::uint32_t j) { return j * columns + i; };
  for (std::uint32_t j = 0; j <= grid.cells_v; ++j) {
    for (std::uint32_t i = 0; i <= grid.cells_u; ++i) {
      const dvec2 uv(double(i) / grid.cells_u, double(j) / grid.cells_v);
      const AnalyticPoint point = surface(uv.x, uv.y);
      mesh.position.push_back(point.position);
      mesh.normal.push_back(point.normal);
      mesh.uv.push_back(uv);
      mesh.point.push_back(mesh.point_count++);
      mesh.bounds.add(point.position);
    }
  }
  for (std::uint32_t j = 0; j < grid.cells_v; ++j) {
    for (std::uint32_t i = 0; i < grid.cells_u; ++i) {
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)});
      mesh.triangles.push_back({corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)});
    }
  }
  if (grid.line_every == 0) return mesh;
  for (std::uint32_t j = 0; j <= grid.cells_v; j += grid.line_every) {
    auto& line = mesh.lines.emplace_back();
    for (std::uint32_t i = 0; i <= grid.cells_u; ++i) line.push_back(corner(i, j));
  }
  for (std::uint32_t i = 0; i <= grid.cells_u; i += grid.line_every) {
    auto& line = mesh.lines.emplace_back();
    for (std::uint32_t j = 0; j <= grid.cells_v; ++j) line.push_back(corner(i, j));
  }
  return mesh;
}

/// Outward.
inline Mesh sphere_mesh(const dvec3& centre, double radius, const AnalyticGrid& grid = {}) {
  return analytic_mesh(
      [&](double s, double t) {
        const double u = 2 * std::numbers::pi * s;
        const double v = std::numbers::pi * (t - 0.5);
        const dvec3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
        return AnalyticPoint{centre + radius * n, n};
      },
      grid);
}

/// Around z; `major` is the circle's radius, `minor` the tube's. Outward.
inline Mesh torus_mesh(double major, double minor, const AnalyticGrid& grid = {}) {
  return analytic_mesh(
      [&](double s, double t) {
        const double u = 2 * std::numbers::pi * s;
        const double v = 2 * std::numbers::pi * t;
        const dvec3 n(std::cos(u) * std::cos(v), std::sin(u) * std::cos(v), std::sin(v));
        return AnalyticPoint{dvec3(major * std::cos(u), major * std::sin(u), 0) + minor * n, n};
      },
      grid);
}

/// The square |x| <= half, |y| <= half at z = 0 around `centre`; its front is +z.
inline Mesh plane_mesh(const dvec3& centre, double half, const AnalyticGrid& grid = {}) {
  return analytic_mesh(
      [&](double s, double t) {
        return AnalyticPoint{centre + half * dvec3(2 * s - 1, 2 * t - 1, 0), dvec3(0, 0, 1)};
      },
      grid);
}

}  // namespace saddle
