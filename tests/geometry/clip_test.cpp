// Cutting a mesh along the faces of a box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "mesh/adaptive_mesh.h"
#include "mesh_checks.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

GridMesh clipped(const Surface& surface, const Bounds& box) {
  AdaptiveOptions options;
  options.tolerance = [](const Probe&) { return Tolerance(4e-3); };
  options.clip = box;
  return mesh_within_tolerance(surface, options).value();
}

Surface height(const char* z) {
  return surface_from_text("u", "v", z, {-1, 1, -1, 1}, {}, Order::Second);
}

double smallest_area(const Mesh& mesh) {
  double smallest = kNoLimit;
  for (const Triangle& t : mesh.triangles) {
    smallest = std::min(smallest, glm::length(doubled_area(mesh, t)));
  }
  return smallest;
}

std::size_t count_open_edges(const Mesh& mesh) {
  std::map<PointEdge, int> counts;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) ++counts[point_edge(mesh, t[k], t[(k + 1) % 3])];
  }
  std::size_t open = 0;
  for (const auto& [edge, count] : counts) {
    EXPECT_LE(count, 2);
    open += count == 1 ? 1 : 0;
  }
  return open;
}

TEST(Clip, LeavesNoTrianglesWithoutAreaWhereVerticesAreOnAFace) {
  // Lines of the mesh are on the faces, and so are vertices that nothing runs along.
  const Surface slope = height("u");
  const Surface saddle_surface = height("u*v");
  const Bounds part{dvec3(0.2, -1, -1), dvec3(0.8, 1, 1)};
  const Bounds quarter{dvec3(0, 0, 0), dvec3(1, 1, 1)};
  const GridMesh strip = clipped(slope, part);
  EXPECT_NEAR(area(strip.mesh), 0.6 * 2 * std::sqrt(2.0), 1e-12);
  EXPECT_GT(smallest_area(strip.mesh), 1e-6);
  EXPECT_EQ(euler_number(strip.mesh), 1);
  const GridMesh corner = clipped(saddle_surface, quarter);
  EXPECT_GT(smallest_area(corner.mesh), 1e-6);
  EXPECT_EQ(euler_number(corner.mesh), 1);
}

TEST(Clip, CutsATorusAlongItsLinesIntoABand) {
  const Surface torus = surface_from_text("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)",
                                          {0, 2 * kPi, 0, 2 * kPi}, {}, Order::Second);
  const GridMesh half = clipped(torus, {dvec3(-3, -3, 0), dvec3(3, 3, 1)});
  EXPECT_GT(smallest_area(half.mesh), 1e-6);
  EXPECT_EQ(euler_number(half.mesh), 0);
  EXPECT_NEAR(area(half.mesh), 4 * kPi * kPi, 0.1);  // half of 8 pi^2
  EXPECT_GT(count_open_edges(half.mesh), 100U);
  for (const dvec3& p : half.mesh.position) EXPECT_GE(p.z, 0);
}

TEST(Clip, CutsEdgesThatAFaceCrossesBetweenVertices) {
  const GridMesh strip = clipped(height("u"), {dvec3(-kNoLimit), dvec3(0.123, 9, 9)});
  EXPECT_NEAR(area(strip.mesh), 1.123 * 2 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(euler_number(strip.mesh), 1);
}

}  // namespace
}  // namespace saddle
