// Triangles at singular points have normals from their own side; all other normals are the
// formula's.
#include "mesh/grid/facing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
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

bool is_any(std::uint32_t) {
  return true;
}
bool is_none(std::uint32_t) {
  return false;
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
  face_own_triangles(roof(), 1, is_any, mesh);
  ASSERT_EQ(mesh.position.size(), 5U) << "the two share it";
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 4, 2}));
  EXPECT_EQ(mesh.triangles[1], (Triangle{2, 4, 3}));
  EXPECT_EQ(mesh.point[4], mesh.point[1]);
  EXPECT_EQ(mesh.position[4], mesh.position[1]);
  EXPECT_EQ(mesh.uv[4], mesh.uv[1]);
  EXPECT_FALSE(is_opposed(mesh, mesh.triangles[0], 1));
  EXPECT_LT(glm::distance(mesh.normal[4], mesh.normal[0]), 1e-3) << "that of its side";
}

TEST(Facing, KeepsNormalsOfRegularCorners) {
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {1e-3, 0}, {-1, 0}, {-1, 1}}, {{0, 1, 2}, {2, 1, 3}});
  ASSERT_TRUE(is_opposed(mesh, mesh.triangles[0], 1));
  face_own_triangles(roof(), 1, is_none, mesh);
  EXPECT_EQ(mesh.position.size(), 4U);
}

TEST(Facing, LeavesWhatTheSurfaceFacesNowhere) {
  // Turned around: all of its corners oppose it, and so does the surface between.
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {-0.5, 0}, {-1, 1}}, {{0, 2, 1}});
  ASSERT_TRUE(is_opposed(mesh, mesh.triangles[0], 0));
  face_own_triangles(roof(), 1, is_any, mesh);
  EXPECT_EQ(mesh.position.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 2, 1}));
}

TEST(Facing, LeavesWhatAllCornersOpposeTogether) {
  // Though the surface within faces as it does.
  Mesh mesh = mesh_of(roof(), {{-1, -1}, {-0.5, 0}, {-1, 1}}, {{0, 1, 2}});
  ASSERT_FALSE(is_opposed(mesh, mesh.triangles[0], 0));
  for (std::size_t k = 0; k < 3; ++k) mesh.normal[k] = -dvec3(mesh.normal[k]);
  face_own_triangles(roof(), 1, is_any, mesh);
  EXPECT_EQ(mesh.position.size(), 3U);
  EXPECT_EQ(mesh.triangles[0], (Triangle{0, 1, 2}));
}

/// The largest angle between the mesh's normals and those that `normal` gives for u and v.
template <class Normal>
double most_degrees_off(const Surface& surface, Normal normal) {
  const Mesh mesh = try_mesh(surface, within_share(1e-3)).value().mesh;
  double most = 0;
  for (std::size_t k = 0; k < mesh.normal.size(); ++k) {
    const dvec3 exact = glm::normalize(normal(mesh.uv[k].x, mesh.uv[k].y));
    most = std::max(most, degrees_between(mesh.normal[k], exact));
  }
  return most;
}

/// Degrees. A phase of 300 or 50 radians has 1e-14 of rounding, slopes of 1000 multiply it.
constexpr double kNormalRounding = 1e-6;

TEST(Facing, HasTheNormalsOfWavesThatTurnWithinTheTolerance) {
  const Surface waves = height_field("sin(1000*u)", {0, 0.05, -1, 1});
  const auto normal = [](double u, double) { return dvec3(-1000 * std::cos(1000 * u), 0, 1); };
  EXPECT_LT(most_degrees_off(waves, normal), kNormalRounding);
}

TEST(Facing, HasTheNormalsOfAHelicoidWithTurnsNearerThanTheTolerance) {
  const Surface helicoid =
      surface_from_text("u*cos(v)", "u*sin(v)", "v/20", {-1, 1, 0, 300}, {}, Order::Second);
  const auto normal = [](double u, double v) {
    return dvec3(0.05 * std::sin(v), -0.05 * std::cos(v), u);
  };
  EXPECT_LT(most_degrees_off(helicoid, normal), kNormalRounding);
}

}  // namespace
}  // namespace saddle
