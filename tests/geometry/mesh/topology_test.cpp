// Euler numbers, edges and sides of meshes made by hand and of changed surfaces; those of the
// gallery as it is stand in gallery/table.cpp.
#include "mesh/model/topology.h"
#include "mesh/model/mesh_report.h"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/gallery/samples.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult mesh_of(const Scene& scene) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  return mesh_of(surface, scene, 3e-3);
}

TEST(Topology, OfATorusWhoseSeamIsShiftedIsThatOfATorus) {
  for (const char* const shift : {"u/2", "u/3", "-u/4", "2*u/5", "u/6", "4*u/3"}) {
    Scene scene = scene_of("torus", {"u=0:2*pi", "v=0:2*pi"});
    SurfaceSpec& spec = scene.surfaces.at(0);
    const std::string angle = std::string("v+") + shift;
    spec.x = "(R+r*cos(" + angle + "))*cos(u)";
    spec.y = "(R+r*cos(" + angle + "))*sin(u)";
    spec.z = "r*sin(" + angle + ")";
    const MeshResult mesh = mesh_of(scene);
    EXPECT_EQ(mesh.report.closed_u, "shifted") << shift;
    const Topology t = topology(mesh.mesh);
    EXPECT_TRUE(t.is_closed()) << shift;
    EXPECT_TRUE(t.orientable) << shift;
    EXPECT_EQ(t.euler_number, 0) << shift;
  }
}

/// A tube of triangular section, turned by a third on its way around: the other edges meet.
TEST(Topology, OfATurnedTubeWithCornersIsThatOfATorus) {
  Scene scene = scene_of("torus", {"u=0:2*pi", "v=0:2*pi"});
  SurfaceSpec& spec = scene.surfaces.at(0);
  spec.x = "(3+cos(u+v/3)*(1+0.3*cos(3*u)))*cos(v)";
  spec.y = "(3+cos(u+v/3)*(1+0.3*cos(3*u)))*sin(v)";
  spec.z = "sin(u+v/3)*(1+0.3*cos(3*u))";
  const MeshResult mesh = mesh_of(scene);
  EXPECT_EQ(mesh.report.closed_v, "shifted");
  EXPECT_TRUE(topology(mesh.mesh).is_closed());
  EXPECT_EQ(topology(mesh.mesh).euler_number, 0);
}

TEST(Topology, OfAConeIsThatOfADisc) {
  // Vertices of halved cells are on straight lines to the apex.
  const Surface cone =
      surface_from_text("u*cos(v)", "u*sin(v)", "u", {0, 1, 0, 2 * kPi}, {}, Order::Second);
  const Topology t = topology(try_mesh(cone, within_share(1e-3, 3))->mesh);
  EXPECT_EQ(t.euler_number, 1);
  EXPECT_EQ(t.boundary_loops, 1U);
}

TEST(Topology, OfAHalfOfAOneSidedSurfaceIsThatOfABand) {
  const Scene half = scene_of("mobius", {"u=0:2*pi", "v=0.1:0.5"});
  const Topology t = topology(mesh_of(half).mesh);
  EXPECT_TRUE(t.orientable);  // the ends are apart
  EXPECT_EQ(t.euler_number, 1);
}

TEST(Topology, CountsPartsThatShareNoPoint) {
  const Topology t = topology(mesh_of(scene_of("scherk-1-chequerboard", {"a=2"})).mesh);
  EXPECT_EQ(t.components, 5U);
}

/// Corners in general position, of which each is a point of its own.
Mesh mesh_by_hand(std::uint32_t points, const std::vector<Triangle>& triangles) {
  Mesh mesh;
  mesh.point.resize(points);
  for (std::uint32_t k = 0; k < points; ++k) mesh.point[k] = k;
  mesh.point_count = points;
  mesh.triangles.resize(triangles.size());
  std::ranges::copy(triangles, mesh.triangles.begin());
  return mesh;
}

TEST(Topology, OfThreeTrianglesAtAnEdgeIsNotClosed) {
  const Topology t = topology(mesh_by_hand(5, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}));
  EXPECT_EQ(t.shared_edges, 1U);
  EXPECT_EQ(t.open_edges, 6U);
  EXPECT_FALSE(t.is_closed());
}

TEST(Topology, OfTheSmallestProjectivePlaneIsOneSided) {
  // Half of an icosahedron, opposite points taken as one.
  const Topology t = topology(mesh_by_hand(6, {{0, 1, 2},
                                               {0, 2, 3},
                                               {0, 3, 4},
                                               {0, 4, 5},
                                               {0, 5, 1},
                                               {1, 2, 4},
                                               {2, 3, 5},
                                               {3, 4, 1},
                                               {4, 5, 2},
                                               {5, 1, 3}}));
  EXPECT_EQ(t.euler_number, 1);
  EXPECT_TRUE(t.is_closed());
  EXPECT_FALSE(t.orientable);
}

TEST(Topology, OfATetrahedronDoesNotDependOnHowItsTrianglesRun) {
  const Topology t = topology(mesh_by_hand(4, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_EQ(t.euler_number, 2);
  EXPECT_TRUE(t.is_closed());
  EXPECT_TRUE(t.orientable);
}

TEST(Topology, OfNothingIsNothing) {
  const Topology t = topology(Mesh{});
  EXPECT_EQ(t.euler_number, 0);
  EXPECT_EQ(t.components, 0U);
  EXPECT_FALSE(t.is_closed());
}

}  // namespace
}  // namespace saddle
