// Small meshes and the bytes that writers make of them, for tests of exported files.
#pragma once

#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "export/content.h"
#include "mesh/model/mesh.h"
#include "mesh/solid/thicken.h"
#include "scene/model/assignments.h"
#include "scene/model/scene.h"

namespace saddle {

/// A number at a place of a file, little endian, whatever the machine's order.
template <typename Number>
Number number_in(const std::string& bytes, std::size_t at) {
  std::uint64_t bits = 0;
  for (std::size_t i = sizeof(Number); i-- > 0;) {
    bits = bits << 8 | static_cast<std::uint8_t>(bytes.at(at + i));
  }
  Number number;
  if constexpr (sizeof(Number) == 4) {
    const auto low = static_cast<std::uint32_t>(bits);
    std::memcpy(&number, &low, 4);
  } else if constexpr (sizeof(Number) == 2) {
    const auto low = static_cast<std::uint16_t>(bits);
    std::memcpy(&number, &low, 2);
  } else {
    std::memcpy(&number, &bits, sizeof(Number));
  }
  return number;
}

/// The faces of a tetrahedron, with a normal of its own at each corner: 12 corners of 4 points. Its
/// faces look outward unless `turned`.
inline Mesh tetrahedron(const dvec3& offset = {}, bool turned = false) {
  const std::vector<dvec3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const std::vector<Triangle> faces = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};
  Mesh mesh;
  mesh.point_count = 4;
  for (Triangle face : faces) {
    if (turned) std::swap(face[1], face[2]);
    const dvec3 normal = glm::normalize(
        glm::cross(points[face[1]] - points[face[0]], points[face[2]] - points[face[0]]));
    const auto first = static_cast<std::uint32_t>(mesh.position.size());
    for (const std::uint32_t point : face) {
      mesh.position.push_back(points[point] + offset);
      mesh.normal.push_back(normal);
      mesh.uv.push_back({points[point].x, points[point].y});
      mesh.point.push_back(point);
      mesh.bounds.add(mesh.position.back());
    }
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  mesh.lines = {{0, 1}};
  return mesh;
}

/// A unit square in the plane z = 0 that is open: two triangles of four corners.
inline Mesh open_square() {
  Mesh mesh;
  for (std::uint32_t i = 0; i < 4; ++i) {
    mesh.position.push_back({i % 2, i / 2, 0});
    mesh.normal.push_back({0, 0, 1});
    mesh.uv.push_back({i % 2, i / 2});
    mesh.point.push_back(i);
    mesh.bounds.add(mesh.position.back());
  }
  mesh.point_count = 4;
  mesh.triangles = {{0, 1, 3}, {0, 3, 2}};
  return mesh;
}

/// The same with a number at each corner, 0 to 1 along x.
inline Mesh numbered_square() {
  Mesh mesh = open_square();
  for (const dvec3& p : mesh.position) mesh.color.push_back(double(p.x));
  mesh.color_range = {0, 1};
  return mesh;
}

/// The open square as a solid, or the numbered one: 2 triangles in front, 2 behind, 8 of walls.
inline Mesh thick_square(bool numbered = false) {
  return thicken(numbered ? numbered_square() : open_square(), {0.1, 0.1});
}

inline Scene scene_of_surface() {
  Scene scene;
  assign(scene, "z=u*v");
  return scene;
}

inline const Scene kSurfaceScene = scene_of_surface();

template <typename Write>
std::string bytes_of(Write write, const MeshContent& content) {
  std::ostringstream out;
  write(out, content);
  return out.str();
}

}  // namespace saddle
