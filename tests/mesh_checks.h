// Invariants of triangle meshes, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <utility>

#include "mesh/model/mesh.h"

namespace saddle {

/// Twice the vector area of a triangle.
inline dvec3 doubled_area(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  const dvec3& a = mesh.position[t[0]];
  return glm::cross(mesh.position[t[1]] - a, mesh.position[t[2]] - a);
}

inline double area(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) sum += 0.5 * glm::length(doubled_area(mesh, t));
  return sum;
}

/// Of a closed mesh; positive if its front is outside.
inline double volume(const Mesh& mesh) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    sum += glm::dot(mesh.position[t[0]], doubled_area(mesh, t)) / 6;
  }
  return sum;
}

/// The area of the triangles in the plane of the parameters; those that are turned over count
/// negatively.
inline double area_in_uv(const Mesh& mesh) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const dvec2 a = mesh.uv[t[1]] - mesh.uv[t[0]];
    const dvec2 b = mesh.uv[t[2]] - mesh.uv[t[0]];
    sum += 0.5 * (a.x * b.y - a.y * b.x);
  }
  return sum;
}

using PointEdge = std::pair<std::uint32_t, std::uint32_t>;

inline PointEdge point_edge(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  return std::minmax(mesh.point[a], mesh.point[b]);
}

/// How many triangles each edge between points has.
inline std::map<PointEdge, int> edge_counts(const Mesh& mesh) {
  std::map<PointEdge, int> counts;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++counts[point_edge(mesh, t[k], t[(k + 1) % 3])];
  }
  return counts;
}

/// Points - edges + triangles.
inline long euler_number(const Mesh& mesh) {
  return static_cast<long>(mesh.point_count) - static_cast<long>(edge_counts(mesh).size()) +
         static_cast<long>(mesh.triangles.size());
}

/// Triangles that do not face as all three of their normals do.
inline std::size_t triangles_against_normals(const Mesh& mesh) {
  return static_cast<std::size_t>(
      std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
        return std::any_of(t.begin(), t.end(), [&](std::uint32_t corner) {
          return !(glm::dot(doubled_area(mesh, t), mesh.normal[corner]) > 0);
        });
      }));
}

}  // namespace saddle
