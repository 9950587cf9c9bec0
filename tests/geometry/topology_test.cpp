// Euler numbers, edges and sides of gallery surfaces and of meshes made by hand.
#include "mesh/topology.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
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
  long euler_number;
  std::size_t boundary_loops;
  bool orientable = true;
  std::size_t components = 1;
};

constexpr Expected kSphere = {2, 0};
constexpr Expected kTorus = {0, 0};
constexpr Expected kDisc = {1, 1};
constexpr Expected kBand = {0, 2};
constexpr Expected kKlein = {0, 0, false};
constexpr Expected kProjectivePlane = {1, 0, false};

/// Of every surface of the gallery. What passes through itself, and an edge that lies on itself
/// (pillow, guimard, bent-horns, wallis-conical-edge, plucker-conoid), stays apart.
const std::map<std::string, Expected>& topologies() {
  static const std::map<std::string, Expected> table = {
      {"sphere", kSphere},
      {"ellipsoid", kSphere},
      {"astroidal-ellipsoid", kSphere},
      {"superellipsoid", kSphere},
      {"superellipsoid-star", kSphere},
      {"torus", kTorus},
      {"supertoroid", kTorus},
      {"trefoil-tube", kTorus},
      {"bohemian-dome", kTorus},
      {"horn-torus", {1, 0}},     // a sphere, two points of which are one
      {"spindle-torus", {2, 0}},  // two spheres that share two points
      {"eight-surface", {3, 0}},  // two that share one
      {"cone-double", {1, 2}},    // two discs that share one
      {"hyperboloid-2", {2, 2, true, 2}},
      {"scherk-1-chequerboard", {13, 13, true, 13}},
      {"costa", {-3, 3}},  // a torus with three holes
      {"paraboloid", kDisc},
      {"hyperbolic-paraboloid", kDisc},
      {"monkey-saddle", kDisc},
      {"enneper", kDisc},
      {"enneper-polar", kDisc},
      {"helicoid", kDisc},
      {"catenoid-helicoid", kDisc},
      {"scherk-1", kDisc},
      {"scherk-2", kDisc},
      {"scherk-2-tower", kDisc},
      {"catalan", kDisc},
      {"bour", kDisc},
      {"dini", kDisc},
      {"kuen", kDisc},
      {"kuen-log", kDisc},
      {"whitney-umbrella", kDisc},
      {"cuspidal-edge", kDisc},
      {"swallowtail", kDisc},
      {"menn", kDisc},
      {"seashell", kDisc},
      {"conic-spiral", kDisc},
      {"horn", kDisc},
      {"riemann-sqrt", kDisc},
      {"riemann-cbrt", kDisc},
      {"riemann-log", kDisc},
      {"riemann-asin", kDisc},
      {"steinbach-screw", kDisc},
      {"eck-default", kDisc},
      {"cylinder", kBand},
      {"hyperboloid-1", kBand},
      {"catenoid", kBand},
      {"gabriel-horn", kBand},
      {"funnel", kBand},
      {"pseudosphere", kBand},
      {"corkscrew", kBand},
      {"henneberg", kBand},
      {"plucker-conoid", kBand},
      {"plucker-conoid-cartesian", kBand},  // a disc without its middle
      {"wallis-conical-edge", kBand},
      {"pillow", kBand},
      {"guimard", kBand},
      {"bent-horns", kBand},
      {"mobius", {0, 1, false}},
      {"klein-figure8", kKlein},
      {"klein-bottle", kKlein},
      {"cross-cap", kProjectivePlane},
      {"roman", kProjectivePlane},
      {"boy", kProjectivePlane},
  };
  return table;
}

/// Sheets that meet in one point along whole lines of their parameters, of which a mesh finds some.
const std::set<std::string> kManySheetsInOnePoint = {"spherical-harmonic", "bourke-harmonic"};

TEST(Topology, OfEverySurfaceOfTheGalleryIsThatOfItsKind) {
  for (const GalleryEntry& entry : gallery()) {
    const std::string name(entry.name);
    if (kManySheetsInOnePoint.contains(name)) continue;
    const auto expected = topologies().find(name);
    ASSERT_NE(expected, topologies().end()) << name << " has no entry";
    const auto& [euler_number, boundary_loops, orientable, components] = expected->second;
    const GridMesh mesh = mesh_of(gallery_scene(entry));
    const Topology t = topology(mesh.mesh);
    EXPECT_EQ(t.euler_number, euler_number) << name;
    EXPECT_EQ(t.boundary_loops, boundary_loops) << name;
    EXPECT_EQ(t.orientable, orientable) << name;
    EXPECT_EQ(t.components, components) << name;
    EXPECT_EQ(t.shared_edges, 0U) << name;
    EXPECT_EQ(t.is_closed(), boundary_loops == 0) << name;
    EXPECT_EQ(is_orientable(mesh.mesh, mesh.report), orientable) << name;
  }
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
