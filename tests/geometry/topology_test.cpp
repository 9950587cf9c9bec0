// Euler numbers, edges and sides of gallery surfaces and of meshes made by hand.
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "geometry/gallery_samples.h"

namespace saddle {
namespace {

GridMesh mesh_of(const Scene& scene) {
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0), Order::Second).surface;
  return mesh_of(surface, scene, 3e-3);
}

struct Expected {
  std::string name;
  long euler_number;
  std::size_t boundary_loops;
};

void expect_topology(const Expected& expected, bool orientable) {
  const GridMesh mesh = mesh_of(scene_of(expected.name));
  const Topology t = topology(mesh.mesh);
  EXPECT_EQ(t.euler_number, expected.euler_number) << expected.name;
  EXPECT_EQ(t.boundary_loops, expected.boundary_loops) << expected.name;
  EXPECT_EQ(t.orientable, orientable) << expected.name;
  EXPECT_EQ(t.components, 1U) << expected.name;
  EXPECT_EQ(t.shared_edges, 0U) << expected.name;
  EXPECT_EQ(t.is_closed(), expected.boundary_loops == 0) << expected.name;
  EXPECT_EQ(is_orientable(mesh.mesh, mesh.report), orientable) << expected.name;
}

TEST(Topology, OfClosedSurfacesIsThatOfTheirKind) {
  for (const Expected& sphere : std::vector<Expected>{{"sphere", 2, 0},
                                                      {"ellipsoid", 2, 0},
                                                      {"astroidal-ellipsoid", 2, 0},
                                                      {"superellipsoid", 2, 0},
                                                      {"superellipsoid-star", 2, 0}}) {
    expect_topology(sphere, true);
  }
  for (const Expected& torus : std::vector<Expected>{{"torus", 0, 0},
                                                     {"supertoroid", 0, 0},
                                                     {"trefoil-tube", 0, 0},
                                                     {"bohemian-dome", 0, 0}}) {
    expect_topology(torus, true);
  }
  expect_topology({"horn-torus", 1, 0}, true);     // a sphere, two points of which are one
  expect_topology({"eight-surface", 3, 0}, true);  // two spheres that share a point
}

TEST(Topology, OfSurfacesWithEdgesCountsTheEdges) {
  for (const Expected& disc : std::vector<Expected>{{"paraboloid", 1, 1},
                                                    {"enneper", 1, 1},
                                                    {"enneper-polar", 1, 1},
                                                    {"helicoid", 1, 1},
                                                    {"seashell", 1, 1},
                                                    {"conic-spiral", 1, 1},
                                                    {"horn", 1, 1},
                                                    {"riemann-sqrt", 1, 1},
                                                    {"riemann-cbrt", 1, 1},
                                                    {"scherk-2-tower", 1, 1}}) {
    expect_topology(disc, true);
  }
  for (const Expected& band : std::vector<Expected>{{"cylinder", 0, 2},
                                                    {"catenoid", 0, 2},
                                                    {"gabriel-horn", 0, 2},
                                                    {"pseudosphere", 0, 2},
                                                    {"corkscrew", 0, 2},
                                                    {"henneberg", 0, 2}}) {
    expect_topology(band, true);
  }
  expect_topology({"costa", -3, 3}, true);  // a torus with three holes
}

TEST(Topology, OfOneSidedSurfacesSaysSo) {
  expect_topology({"mobius", 0, 1}, false);
  expect_topology({"klein-figure8", 0, 0}, false);
  expect_topology({"klein-bottle", 0, 0}, false);
  expect_topology({"cross-cap", 1, 0}, false);
  expect_topology({"roman", 1, 0}, false);
  expect_topology({"boy", 1, 0}, false);
}

TEST(Topology, OfATorusWhoseSeamIsShiftedIsThatOfATorus) {
  Scene scene = scene_of("torus", {"u=0:2*pi", "v=0:2*pi"});
  SurfaceSpec& spec = scene.surfaces.at(0);
  spec.x = "(R+r*cos(v+u/2))*cos(u)";
  spec.y = "(R+r*cos(v+u/2))*sin(u)";
  spec.z = "r*sin(v+u/2)";
  const GridMesh mesh = mesh_of(scene);
  EXPECT_EQ(mesh.report.closed_u, "shifted");
  const Topology t = topology(mesh.mesh);
  EXPECT_TRUE(t.is_closed());
  EXPECT_TRUE(t.orientable);
  EXPECT_EQ(t.euler_number, 0);
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
