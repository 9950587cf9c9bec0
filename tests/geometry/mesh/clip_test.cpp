// Cutting a mesh along the faces of a box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

MeshResult clipped(const Surface& surface, const Bounds& box) {
  MeshRequest options = within_length(4e-3);
  options.clip = box;
  return try_mesh(surface, options).value();
}

double smallest_area(const Mesh& mesh) {
  double smallest = kNoLimit;
  for (const Triangle& t : mesh.triangles) {
    smallest = std::min(smallest, glm::length(doubled_area(mesh, t)));
  }
  return smallest;
}

std::size_t count_open_edges(const Mesh& mesh) {
  std::size_t open = 0;
  for (const auto& [edge, count] : edge_counts(mesh)) {
    EXPECT_LE(count, 2);
    open += count == 1 ? 1 : 0;
  }
  return open;
}

TEST(Clip, LeavesNoTrianglesWithoutAreaWhereVerticesAreOnAFace) {
  // Lines of the mesh are on the faces, and so are vertices that nothing runs along.
  const Surface slope = height_field("u");
  const Surface saddle_surface = height_field("u*v");
  const Bounds part{dvec3(0.2, -1, -1), dvec3(0.8, 1, 1)};
  const Bounds quarter{dvec3(0, 0, 0), dvec3(1, 1, 1)};
  const MeshResult strip = clipped(slope, part);
  EXPECT_NEAR(area(strip.mesh), 0.6 * 2 * std::sqrt(2.0), 1e-12);
  EXPECT_GT(smallest_area(strip.mesh), 1e-6);
  EXPECT_EQ(euler_number(strip.mesh), 1);
  const MeshResult corner = clipped(saddle_surface, quarter);
  EXPECT_GT(smallest_area(corner.mesh), 1e-6);
  EXPECT_EQ(euler_number(corner.mesh), 1);
}

TEST(Clip, EndsWhereTheSurfaceLeavesTheBox) {
  // z = 0.00275 on a circle. Nothing of the surface in the box is higher than the tolerance.
  constexpr double kHeight = 0.00018;
  constexpr double kFace = 0.00275;
  const double radius = std::sqrt(kHeight / kFace);
  const MeshResult plane = clipped(height_field("0.00018/((u+0.4)^2+(v+0.26)^2)"),
                                   {dvec3(-kNoLimit), dvec3(kNoLimit, kNoLimit, kFace)});
  std::size_t on_face = 0;
  const Mesh& mesh = plane.mesh;
  for (const Triangle& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3& a = mesh.position[t[k]];
      const dvec3& b = mesh.position[t[(k + 1) % 3]];
      if (a.z != kFace || b.z != kFace) continue;
      ++on_face;
      for (const dvec3& p : {a, 0.5 * (a + b)})
        EXPECT_NEAR(glm::length(dvec2(p) + dvec2(0.4, 0.26)), radius, 4e-3);
    }
  }
  EXPECT_GT(on_face, 10U);
}

TEST(Clip, NeedsNoFinerMeshWhereTheCoarseOneHasItsLinesNearEnough) {
  // Chords of length 2/15 are 0.00044 above v^2/10, and the slope is 0.3 or more: lines on the
  // faces are off by at most 0.0015. Sides that a line nearly runs along cross the face elsewhere.
  const Surface valley = height_field("0.3*u+0.1*v^2");
  const Bounds slab{dvec3(-3, -3, -0.2), dvec3(3, 3, 0.1)};
  MeshRequest finer = within_length(2.9e-3);
  finer.clip = slab;
  EXPECT_EQ(try_mesh(valley, finer).value().mesh.triangles.size(),
            clipped(valley, slab).mesh.triangles.size());
}

TEST(Clip, KeepsTheStripThatCrossesTheBoxOnItsWayToAPole) {
  // Beside u = v = -1 the surface rises from below the box to a pole above it between two corners
  // of a cell.
  const Surface surface = height_field("u+v-0.0198/(u-v)");
  const MeshResult strip =
      clipped(surface, {dvec3(-kNoLimit, -kNoLimit, -1.2), dvec3(kNoLimit, kNoLimit, 1.2)});
  const TriangleTree tree(strip.mesh);
  for (const double u : {-1.0, -0.999, -0.99}) {
    for (double d = 0.005; d < 0.03; d += 0.0005) {
      const dvec3 p(u, u + d, 2 * u + d + 0.0198 / d);
      if (std::fabs(p.z) < 1.2) {
        EXPECT_LE(tree.distance(p), 4.1e-3) << u << " " << d;
      }
    }
  }
}

TEST(Clip, CutsATorusAlongItsLinesIntoABand) {
  const Surface torus = surface_from_text("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)",
                                          {0, 2 * kPi, 0, 2 * kPi}, {}, Order::Second);
  const MeshResult half = clipped(torus, {dvec3(-3, -3, 0), dvec3(3, 3, 1)});
  EXPECT_GT(smallest_area(half.mesh), 1e-6);
  EXPECT_EQ(euler_number(half.mesh), 0);
  EXPECT_NEAR(area(half.mesh), 4 * kPi * kPi, 0.1);  // half of 8 pi^2
  EXPECT_GT(count_open_edges(half.mesh), 100U);
  for (const dvec3& p : half.mesh.position) EXPECT_GE(p.z, 0);
}

TEST(Clip, CutsEdgesThatAFaceCrossesBetweenVertices) {
  const MeshResult strip = clipped(height_field("u"), {dvec3(-kNoLimit), dvec3(0.123, 9, 9)});
  EXPECT_NEAR(area(strip.mesh), 1.123 * 2 * std::sqrt(2.0), 1e-12);
  EXPECT_EQ(euler_number(strip.mesh), 1);
}

TEST(Clip, CutsAlongTheBox) {
  const Surface sphere = surface_from_text("cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)",
                                           {0, 2 * kPi, -kPi / 2, kPi / 2}, {}, Order::Second);
  MeshRequest options = within_share(1e-3, 3);
  options.clip = Bounds{dvec3(-2, -2, -0.3), dvec3(2, 0.5, 2)};
  const Mesh mesh = try_mesh(sphere, options)->mesh;
  EXPECT_EQ(mesh.bounds.low.z, -0.3);
  EXPECT_EQ(mesh.bounds.high.y, 0.5);
  EXPECT_EQ(euler_number(mesh), 1);  // a disc: both cuts are one loop
  std::vector<std::vector<std::uint32_t>> corners(mesh.point_count);
  for (std::uint32_t k = 0; k < mesh.point.size(); ++k) corners[mesh.point[k]].push_back(k);
  for (const auto& [edge, count] : edge_counts(mesh)) {
    ASSERT_LE(count, 2);
    if (count == 2) continue;
    for (const std::uint32_t point : {edge.first, edge.second}) {
      for (const std::uint32_t corner : corners[point]) {
        const dvec3& p = mesh.position[corner];
        EXPECT_TRUE(p.z == -0.3 || p.y == 0.5) << p.x << ' ' << p.y << ' ' << p.z;
        EXPECT_NEAR(glm::length(p), 1, 4e-3);
      }
    }
  }
  EXPECT_EQ(triangles_against_normals(mesh), 0U);
  EXPECT_GT(mesh.lines.size(), 20U);
}

TEST(Clip, NeedsNoDenseLinesForWhatItLeavesOut) {
  // Beside the pole it takes lines as close as doubles go, out where nothing is kept.
  const Surface funnel = height_field("1/((u-0.4)^2+(v-0.1)^2)");
  MeshRequest options = within_length(2e-3);
  options.clip = Bounds{dvec3(-1, -1, 0), dvec3(1, 1, 3)};
  const MeshResult mesh = try_mesh(funnel, options).value();
  EXPECT_LE(mesh.report.max_error, 2e-3);
  EXPECT_LT(mesh.mesh.triangles.size(), 4000);
}

/// Beside a pole that leaves the box within a narrow cell: what is out of the box does not count,
/// and what comes back into it is as fine as elsewhere.
TEST(Clip, KeepsTheToleranceBesidePoles) {
  const struct {
    const char* z;
    double half;  // of the domain's sides
    Bounds box;
    double tolerance;
  } cases[] = {
      {"cot(u*v)", 2, {dvec3(-2, -2, -8.267), dvec3(2, 2, 7.733)}, 0.0109},
      {"1/sin(3*u*v)", 2, {dvec3(-2, -2, -8), dvec3(2, 2, 8)}, 0.011},
      {"(u+v)/(u-v)", 1, {dvec3(-1, -1, -4.243), dvec3(1, 1, 3.757)}, 5.44e-3},
  };
  for (const auto& [z, half, box, tolerance] : cases) {
    MeshRequest options = within_length(tolerance);
    options.normal_tolerance = 3;
    options.clip = box;
    const Surface surface = height_field(z, {-half, half, -half, half});
    const MeshResult result = try_mesh(surface, options).value();
    EXPECT_LE(result.report.max_error, tolerance) << z;
  }
}

/// Beside 0 doubles go down to 2^-1074: u ln(v) leaves the box there for all but the least of u,
/// and what goes on by less than the tolerance from one power of 2 to the next is a pole as well.
TEST(Clip, FollowsPolesAtZeroToTheLeastOfDoubles) {
  const struct {
    const char* z;
    Domain domain;
    double half;  // of the box's height
    double tolerance;
  } cases[] = {{"u*ln(abs(v))", {0, 2, 0, 2}, 8.3, 7.6e-3},
               {"u*ln(abs(v))", {-10, 10, -10, 10}, 40, 0.057},
               {"u*ln(v)", {-2, 2, -2, 2}, 1.6185, 4.3e-3},
               {"ln(abs(u))*ln(abs(v))", {-5, 5, -5, 5}, 2, 0.0106}};
  for (const auto& [z, domain, half, tolerance] : cases) {
    MeshRequest options = within_length(tolerance);
    options.normal_tolerance = 3;
    options.clip = Bounds{dvec3(-10, -10, -half), dvec3(10, 10, half)};
    const Surface surface = height_field(z, domain);
    const MeshResult result = try_mesh(surface, options).value();
    EXPECT_LE(result.report.max_error, tolerance) << z << ' ' << domain.u0;
  }
}

/// Where a jump crosses a pole, the surface is beyond one face of the box on one side, and beyond
/// the opposite one on the other.
TEST(Clip, KeepsTheToleranceOfEdgesBesideWhatItCutsAway) {
  // Both discs end at jumps to what is outside of the box. The second one is on a face.
  constexpr double kTolerance = 1e-4;
  MeshRequest request = within_length(kTolerance);
  request.clip = Bounds{dvec3(-1, -1, 1), dvec3(1, 1, 2)};
  const Surface steep = height_field("(u^2+v^2<0.5)?1.5+u/4:0");
  const Surface on_face = height_field("(u^2+v^2<0.5)?1:0");
  const MeshResult one = try_mesh(steep, request).value();
  const MeshResult other = try_mesh(on_face, request).value();
  const TriangleTree steep_disc(one.mesh);
  const TriangleTree flat_disc(other.mesh);
  double worst = 0;
  for (int k = 0; k < 1000; ++k) {
    const double angle = 2 * kPi * k / 1000;
    const double u = std::sqrt(0.5) * std::cos(angle);
    const double v = std::sqrt(0.5) * std::sin(angle);
    worst =
        std::max({worst, steep_disc.distance({u, v, 1.5 + u / 4}), flat_disc.distance({u, v, 1})});
  }
  EXPECT_LE(worst, kTolerance);
  EXPECT_LE(one.report.max_error, kTolerance);
  EXPECT_LE(other.report.max_error, kTolerance);
}

TEST(Clip, HasNoWallsWhereAJumpCrossesAPole) {
  for (const char* z : {"sign(u-v)/(u+.2*v-.1)", "sign(u-.7*v)*tan(4*u+3*v)",
                        "sign(u-.7*v)/(u*u+v*v-.17)", "1/(mod(u,.5)-v)"}) {
    const Mesh mesh = clipped(height_field(z), {dvec3(-1, -1, -4), dvec3(1, 1, 4)}).mesh;
    for (const Triangle& t : mesh.triangles) {
      Bounds around;
      for (const std::uint32_t corner : t) around.add(mesh.position[corner]);
      // As steep sheets are, wider ones are not.
      EXPECT_FALSE(around.size().z > 4 && around.size().x < 1e-3 && around.size().y < 1e-3)
          << z << " at " << around.low.x << ' ' << around.low.y;
    }
  }
}

/// A cell along a pole, between dense lines, is no area full of waves.
TEST(Clip, FindsNoOscillationAlongAPole) {
  MeshRequest options = within_length(0.0116);
  options.normal_tolerance = 3;
  options.clip = Bounds{dvec3(-5, -5, -5.007), dvec3(5, 5, 5.007)};
  const Surface surface = height_field("u/v", {-5, 5, -5, 5});
  const MeshResult result = try_mesh(surface, options).value();
  EXPECT_FALSE(result.report.oscillates);
  EXPECT_LE(result.report.max_error, 0.0116);
}

/// At a rim beside which it goes to infinity slowly, cells of any size reach through the face.
TEST(Clip, EndsWhatGoesToInfinityAtARimOnTheFace) {
  const struct {
    const char* z;
    std::size_t parts;
  } cases[] = {{"ln(u+v)", 1}, {"ln(u*v)", 2}, {"ln(1-u^2-v^2)", 1}};
  for (const auto& [z, parts] : cases) {
    MeshRequest options = within_length(1e-2);
    options.clip = Bounds{dvec3(-1, -1, -7.8), dvec3(1, 1, 9)};
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_LE(result.report.max_error, 1e-2) << z;
    EXPECT_EQ(topology(result.mesh).components, parts) << z;
    EXPECT_EQ(result.mesh.bounds.low.z, -7.8) << z;
    EXPECT_GT(result.report.pole_count, 0U) << z;
    EXPECT_LT(result.mesh.triangles.size(), 6000U) << z;
  }
}

/// Between the corners of a cell, however large, the sheets on both sides of a pole end on a face.
TEST(Clip, EndsBothSidesOfAPoleOnTheFace) {
  constexpr double kHalf = 7.8;  // of the box's height
  const struct {
    const char* z;
    std::size_t parts;
    std::size_t triangles;  // at most
  } cases[] = {{"ln(abs(u^2+v^2-0.5))", 2, 7000}, {"ln(abs(u-0.3*v))", 2, 5000},
               {"ln(abs(u^2-v^2))", 4, 20'000},   {"1/(u-v^2)", 2, 3000},
               {"tan(3*(u+v))", 5, 9000},         {"cot(3*u*v)", 4, 4000}};
  for (const auto& [z, parts, triangles] : cases) {
    MeshRequest options = within_length(1e-2);
    options.clip = Bounds{dvec3(-1, -1, -kHalf), dvec3(1, 1, kHalf)};
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_LE(result.report.max_error, 1e-2) << z;
    EXPECT_EQ(topology(result.mesh).components, parts) << z;
    EXPECT_EQ(result.mesh.bounds.low.z, -kHalf) << z;
    EXPECT_GT(result.report.pole_count, 0U) << z;
    EXPECT_LT(result.mesh.triangles.size(), triangles) << z;
  }
}

/// The largest distance from a mesh of the surface within a box, on a line beside v.
double largest_distance_beside(double v, const Surface& surface, const Bounds& box,
                               const TriangleTree& mesh) {
  constexpr double kBeside = 1e-7;
  constexpr int kPlaces = 1000;
  std::vector<dvec2> places;
  for (int k = 0; k <= kPlaces; ++k) places.emplace_back(2.0 * k / kPlaces - 1, v - kBeside);
  double largest = 0;
  for (const dvec3& p : evaluate_positions(surface, places)) {
    if (box.contains(p)) largest = std::max(largest, mesh.distance(p));
  }
  return largest;
}

/// The sheet on the finite side of a pole leaves the box between sides of cells. A vertex of one
/// side is outside of the box then, beside the pole, or the sheet ends at a chord before it.
TEST(Clip, ReachesPolesFromTheirFiniteSides) {
  constexpr double kTolerance = 0.02;
  const char* const cases[] = {"u/mod(v,0.1)", "(u+v)/mod(v,0.1)", "(v>0.1)?1/(v-0.1):20*u",
                               "(v>0.1)?1/(v-0.1):20*u*(1+v)"};
  for (const char* const z : cases) {
    const Surface surface = height_field(z);
    MeshRequest options = within_length(kTolerance);
    options.clip = Bounds{dvec3(-1, -1, -9.9857), dvec3(1, 1, 9.9857)};
    options.lines = {15, 15};
    const MeshResult result = try_mesh(surface, options).value();
    const TriangleTree mesh(result.mesh);
    for (int k = -9; k <= 10; ++k)
      EXPECT_LE(largest_distance_beside(0.1 * k, surface, *options.clip, mesh), kTolerance)
          << z << ", v = " << 0.1 * k;
  }
}

/// Rounding beside the pole must not lead to a refinement along all of it.
TEST(Clip, TakesFewTrianglesWhereAPoleCrossesZero) {
  MeshRequest options = within_length(0.008);
  options.clip = Bounds{dvec3(-1, -1, -3.876), dvec3(1, 1, 3.876)};
  options.lines = {15, 15};
  const MeshResult result = try_mesh(height_field("tan(1.605*u)*v"), options).value();
  EXPECT_FALSE(result.report.reached_limit);
  EXPECT_LT(result.mesh.triangles.size(), 3000U);
}

/// Cells that are cut have twice as many triangles, and those count.
TEST(Clip, KeepsTheLimitOfTrianglesWherePolesEndOnFaces) {
  MeshRequest options = within_length(1e-3);
  options.clip = Bounds{dvec3(-3, -3, -5), dvec3(3, 3, 5)};
  options.max_triangles = 10'000;
  const Surface surface = height_field("tan(3*u*v)", {-3, 3, -3, 3});
  const MeshResult result = try_mesh(surface, options).value();
  EXPECT_TRUE(result.report.reached_limit);
  EXPECT_LE(result.mesh.triangles.size(), options.max_triangles);
  EXPECT_GT(result.mesh.triangles.size(), options.max_triangles / 2);
}

}  // namespace
}  // namespace saddle
