// Triangles beside a bend that is sharper than the mesh sees have normals from their own side.
#include "mesh/grid/facing.h"

#include <gtest/gtest.h>

#include <vector>

#include "surface_from_text.h"

namespace saddle {
namespace {

/// A roof with a ridge along u = 0 that is round within 1e-4, and so steep that what faces one way
/// opposes the other.
Surface roof() {
  return surface_from_text("u", "v", "-9*hypot(u,1e-4)", {-1, 1, -1, 1}, {}, Order::First);
}

/// Vertices at some places, with the surface's own normals, and triangles of them.
Mesh mesh_of(const Surface& surface, const std::vector<dvec2>& places,
             const std::vector<Triangle>& triangles) {
  Mesh mesh;
  for (const SurfacePoint& point : evaluate(surface, places, 1)) {
    mesh.point.push_back(static_cast<std::uint32_t>(mesh.point.size()));
    mesh.position.push_back(point.position);
    mesh.normal.push_back(glm::normalize(glm::cross(point.r_u, point.r_v)));
  }
  for (const dvec2& place : places) mesh.uv.push_back(place);
  for (const Triangle& triangle : triangles) mesh.triangles.push_back(triangle);
  return mesh;
}

bool is_opposed(const Mesh& mesh, const Triangle& t, std::size_t slot) {
  const dvec3& first = mesh.position[t[0]];
  const dvec3 area = glm::cross(mesh.position[t[1]] - first, mesh.position[t[2]] - first);
  return glm::dot(area, mesh.normal[t[slot]]) < 0;
}

TEST(Facing, GivesTrianglesBeyondARidgeOneCornerOfTheirOwn) {
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {1e-3, 0}, {-1, 0}, {-1, 1}}, {{0, 1, 2}, {2, 1, 3}});
  ASSERT_TRUE(is_opposed(mesh, mesh.triangles[0], 1));
  ASSERT_TRUE(is_opposed(mesh, mesh.triangles[1], 1));
  face_own_triangles(roof(), 1, mesh);
  ASSERT_EQ(mesh.position.size(), 5U) << "the two share it";
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 4, 2}));
  EXPECT_EQ(mesh.triangles[1], (Triangle{2, 4, 3}));
  EXPECT_EQ(mesh.point[4], mesh.point[1]);
  EXPECT_EQ(mesh.position[4], mesh.position[1]);
  EXPECT_EQ(mesh.uv[4], mesh.uv[1]);
  EXPECT_FALSE(is_opposed(mesh, mesh.triangles[0], 1));
  EXPECT_LT(glm::distance(mesh.normal[4], mesh.normal[0]), 1e-3) << "that of its side";
}

TEST(Facing, LeavesWhatTheSurfaceFacesNowhere) {
  // Turned around: all of its corners oppose it, and so does the surface between.
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {-0.5, 0}, {-1, 1}}, {{0, 2, 1}});
  ASSERT_TRUE(is_opposed(mesh, mesh.triangles[0], 0));
  face_own_triangles(roof(), 1, mesh);
  EXPECT_EQ(mesh.position.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 2, 1}));
}

TEST(Facing, LeavesWhatAllCornersOpposeTogether) {
  // Though the surface within faces as it does.
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {-0.5, 0}, {-1, 1}}, {{0, 1, 2}});
  ASSERT_FALSE(is_opposed(mesh, mesh.triangles[0], 0));
  for (std::size_t k = 0; k < 3; ++k) mesh.normal[k] = -dvec3(mesh.normal[k]);
  face_own_triangles(roof(), 1, mesh);
  EXPECT_EQ(mesh.position.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
}

}  // namespace
}  // namespace saddle
