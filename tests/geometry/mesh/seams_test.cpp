// Edges of the domain that meet, and grid lines.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "mesh/mesher/grid_mesh.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kTwoPi = 2 * kPi;

MeshResult mesh(const Surface& surface, int cells_u, int cells_v, int lines_u = 0,
                int lines_v = 0) {
  return mesh_on_grid(surface, {cells_u, cells_v, lines_u, lines_v, 2});
}

Surface torus() {
  return surface_from_text("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)",
                           {0, kTwoPi, 0, kTwoPi});
}

Surface mobius() {
  return surface_from_text("(1+v*cos(u/2))*cos(u)", "(1+v*cos(u/2))*sin(u)", "v*sin(u/2)",
                           {0, kTwoPi, -0.5, 0.5});
}

Surface klein() {
  return surface_from_text("(2+w)*cos(u)", "(2+w)*sin(u)", "sin(u/2)*sin(v)+cos(u/2)*sin(2*v)",
                           {0, kTwoPi, 0, kTwoPi}, {{"w", "cos(u/2)*sin(v)-sin(u/2)*sin(2*v)"}});
}

TEST(Seams, OfATorusJoinBothWays) {
  const MeshResult result = mesh(torus(), 12, 9);
  EXPECT_EQ(result.report.closed_u, "join");
  EXPECT_EQ(result.report.closed_v, "join");
  EXPECT_EQ(result.mesh.position.size(), 13U * 10);
  EXPECT_EQ(result.mesh.point_count, 12U * 9);
  EXPECT_EQ(euler_number(result.mesh), 0);
}

TEST(Seams, KeepBothSidesParametersAndTakeThePositionOfTheFirst) {
  const Mesh m = mesh(torus(), 12, 9).mesh;
  // Corners are in the order of the grid: 12 is the last of the first row.
  EXPECT_EQ(m.uv[0].x, 0);
  EXPECT_EQ(m.uv[12].x, kTwoPi);
  EXPECT_EQ(m.point[0], m.point[12]);
  EXPECT_EQ(m.position[12], dvec3(3, 0, 0));  // at u = 2 pi the formula has y = -7e-16
}

TEST(Seams, OfAMobiusBandMeetReversed) {
  const MeshResult result = mesh(mobius(), 12, 4);
  EXPECT_EQ(result.report.closed_u, "reversed");
  EXPECT_EQ(result.report.closed_v, "");
  EXPECT_EQ(euler_number(result.mesh), 0);
  EXPECT_EQ(result.mesh.point_count, 12U * 5);
}

TEST(Seams, OfAKleinBottleMeetReversedAndJoin) {
  const MeshResult result = mesh(klein(), 16, 12);
  EXPECT_EQ(result.report.closed_u, "reversed");
  EXPECT_EQ(result.report.closed_v, "join");
  EXPECT_EQ(euler_number(result.mesh), 0);
  EXPECT_EQ(result.mesh.point_count, 16U * 12);
  for (const auto& [edge, count] : edge_counts(result.mesh)) EXPECT_NE(edge.first, edge.second);
}

/// A torus whose tube is turned on the way around, by half or another part.
Surface turned_torus(const std::string& turns = "1/2") {
  const std::string angle = "(v+u*" + turns + ")";
  return surface_from_text("(2+cos" + angle + ")*cos(u)", "(2+cos" + angle + ")*sin(u)",
                           "sin" + angle, {0, kTwoPi, 0, kTwoPi});
}

TEST(Seams, ThatAreShiftedByHalfAreFoundWhereHalfIsAVertex) {
  const MeshResult even = mesh(turned_torus(), 16, 12);
  EXPECT_EQ(even.report.closed_u, "shifted");
  EXPECT_EQ(even.report.closed_v, "join");
  EXPECT_EQ(euler_number(even.mesh), 0);
  EXPECT_EQ(even.mesh.point_count, 16U * 12);
  EXPECT_EQ(mesh(turned_torus(), 16, 11).report.closed_u, "");
}

TEST(Seams, ThatAreShiftedByAnotherPartAreFoundWhereItIsAVertex) {
  const MeshResult third = mesh(turned_torus("1/3"), 16, 12);
  EXPECT_EQ(third.report.closed_u, "shifted");
  EXPECT_EQ(third.report.shift_u.parts, 2U);
  EXPECT_EQ(third.report.shift_u.of, 3U);
  EXPECT_EQ(euler_number(third.mesh), 0);
  EXPECT_EQ(third.mesh.point_count, 16U * 12);
  EXPECT_EQ(mesh(turned_torus("1/3"), 16, 16).report.closed_u, "");
}

TEST(Seams, LeadBackToWhereTheyComeFrom) {
  for (const Seam& seam : kSeams) {
    for (const int k : {0, 1, 7, 30, 59}) {
      const int there = seam.partner(k, 60);
      EXPECT_EQ(seam.partner_back(there, 60) % 60, k) << seam.shift.parts << '/' << seam.shift.of;
    }
  }
}

TEST(Seams, HavePositionsEqualToTheBitEverywhere) {
  for (const Surface& surface : {torus(), turned_torus(), turned_torus("3/4"), mobius(), klein()}) {
    const Mesh m = mesh(surface, 16, 12).mesh;
    std::vector<std::size_t> first(m.point_count, m.point.size());
    for (std::size_t k = 0; k < m.point.size(); ++k) {
      if (first[m.point[k]] == m.point.size()) first[m.point[k]] = k;
      EXPECT_EQ(m.position[k], m.position[first[m.point[k]]]);
    }
  }
}

TEST(Seams, ThatAreReversedTakeThePositionsOfTheFirstEdgeToo) {
  const Mesh m = mesh(mobius(), 12, 4).mesh;
  for (std::size_t k = 0; k < m.uv.size(); ++k) {
    if (m.uv[k].x != 0) continue;
    EXPECT_EQ(m.position[k], evaluate(mobius(), std::span(&m.uv[k], 1)).front().position);
  }
}

TEST(Seams, OfADiscAreNone) {
  const MeshResult result = mesh(surface_from_text("u", "v", "u*v", {}), 6, 5);
  EXPECT_EQ(result.report.closed_u, "");
  EXPECT_EQ(result.report.closed_v, "");
  EXPECT_EQ(euler_number(result.mesh), 1);
  EXPECT_EQ(result.mesh.point_count, result.mesh.position.size());
}

TEST(Seams, AreNotMadeAcrossASmallGap) {
  // The gap is 1e-6 of the circumference: a thousand times the tolerance.
  const Surface open = surface_from_text("cos(u)", "sin(u)", "v", {0, kTwoPi * (1 - 1e-6), -1, 1});
  EXPECT_EQ(mesh(open, 12, 4).report.closed_u, "");
}

TEST(Seams, AreMadeAlongTheDefinedPartOfAnEdge) {
  const Surface holed =
      surface_from_text("cos(u)", "sin(u)", "v+0*sqrt(0.3-v)", {0, kTwoPi, -1, 1});
  const MeshResult result = mesh(holed, 12, 10);
  EXPECT_EQ(result.report.closed_u, "join");
  EXPECT_EQ(euler_number(result.mesh), 0);
}

/// Two sheets sewn together: each of the edges u = 0 and u = pi is a segment, there and back.
Surface pillow(Order order = Order::First) {
  return surface_from_text("cos(u)", "cos(v)", "sin(u)*sin(v)", {0, kPi, -kPi, kPi}, {}, order);
}

/// The number of different points on an edge of constant u, all of whose corners of one point are
/// at one place.
std::size_t points_on(const Mesh& m, double u) {
  std::set<std::uint32_t> points;
  for (std::size_t k = 0; k < m.uv.size(); ++k) {
    if (m.uv[k].x != u) continue;
    points.insert(m.point[k]);
    for (std::size_t other = 0; other < k; ++other) {
      if (m.uv[other].x != u || m.uv[other].y != -m.uv[k].y) continue;
      EXPECT_EQ(m.point[other], m.point[k]);
      EXPECT_EQ(m.position[other], m.position[k]);
    }
  }
  return points.size();
}

TEST(Seams, OfAFoldedEdgeJoinItsHalves) {
  const MeshResult even = mesh(pillow(), 10, 12);
  EXPECT_EQ(even.report.folded_u, (std::array{true, true}));
  EXPECT_EQ(even.report.folded_v, (std::array{false, false}));
  EXPECT_EQ(even.report.closed_u, "");
  EXPECT_EQ(points_on(even.mesh, 0), 7U);
  EXPECT_EQ(euler_number(even.mesh), 2);
  // A cell of an odd number has the turning point in the middle of its side.
  EXPECT_EQ(euler_number(mesh(pillow(), 10, 13).mesh), 2);
}

TEST(Seams, OfAFoldedEdgeJoinTheHalvesOfAMeshWithinATolerance) {
  for (const int lines : {0, 16, 17}) {
    MeshRequest options = within_length(5e-3);
    options.lines = {lines, lines};
    const MeshResult result = try_mesh(pillow(Order::Second), options).value();
    EXPECT_EQ(result.report.folded_u, (std::array{true, true}));
    EXPECT_EQ(euler_number(result.mesh), 2);
    const std::size_t corners = static_cast<std::size_t>(
        std::ranges::count(result.mesh.uv, 0.0, [](const dvec2& uv) { return uv.x; }));
    EXPECT_LT(points_on(result.mesh, 0), corners);
  }
}

TEST(Seams, HaveNoGapsWhereOneSideIsHalvedMoreOftenThanTheOther) {
  // A ridge that ends beside the seam; beyond that cells are as large as those of a torus.
  const Surface surface = surface_from_text(
      "(2+r*cos(v))*cos(u)", "(2+r*cos(v))*sin(u)", "r*sin(v)", {0, kTwoPi, 0, kTwoPi},
      {{"r", "1+0.2*max(0,1-((u-0.3)/0.29)^2)^3*exp(-((v-3)/0.02)^2)"}}, Order::Second);
  for (const double tolerance : {0.1, 0.03, 0.01, 0.003}) {
    MeshRequest options = within_length(tolerance);
    options.lines = {0, 0};
    const MeshResult result = try_mesh(surface, options).value();
    EXPECT_EQ(result.report.closed_u, "join");
    EXPECT_EQ(euler_number(result.mesh), 0) << tolerance;
    for (const auto& [edge, count] : edge_counts(result.mesh)) ASSERT_EQ(count, 2) << tolerance;
  }
}

TEST(Seams, OfAnEdgeThatTurnsBackElsewhereAreNone) {
  const Surface off_middle = surface_from_text("u", "(v-0.3)^2+u*v", "u*v", {0, 1, -1, 1});
  EXPECT_EQ(mesh(off_middle, 10, 20).report.folded_u, (std::array{false, false}));
  // Neighbours at the same place with a curve between them are no pole.
  const Surface beside = surface_from_text("u", "(v-0.05)^2+u*v", "u*v", {0, 1, -1, 1});
  EXPECT_EQ(mesh(beside, 10, 20).mesh.point_count, 11U * 21);
}

TEST(Seams, AtAPoleAreOnePoint) {
  const Surface sphere =
      surface_from_text("cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)", {0, kTwoPi, 0, kPi});
  const Mesh m = mesh(sphere, 10, 6).mesh;
  std::set<std::uint32_t> north;
  for (std::size_t k = 0; k < m.uv.size(); ++k) {
    if (m.uv[k].y == 0) north.insert(m.point[k]);
  }
  EXPECT_EQ(north.size(), 1U);
}

TEST(Seams, OfASpikeAreNotDecidedByItsHeight) {
  // The diagonal is 1e12, and every gap is far below 1e-9 of that.
  const Surface spike = surface_from_text("u", "v", "1/(u^2+v^2+1e-12)", {});
  const MeshResult result = mesh(spike, 10, 10);
  EXPECT_EQ(result.report.closed_u, "");
  EXPECT_EQ(result.mesh.point_count, 121U);
}

/// A superquadric, or a torus of such sections. The ends of the ranges are multiples of pi, where
/// sin and cos are 1e-16, and 1e-16^0.2 is 6e-4.
Surface superquadric(double exponent, const Domain& domain, bool is_torus) {
  const std::string power = std::to_string(exponent);
  const std::vector<Definition> definitions = {{"c", "sign(cos(v))*abs(cos(v))^" + power},
                                               {"s", "sign(sin(v))*abs(sin(v))^" + power},
                                               {"a", "sign(cos(u))*abs(cos(u))^" + power},
                                               {"b", "sign(sin(u))*abs(sin(u))^" + power}};
  const std::string radius = is_torus ? "(3+c)" : "c";
  return surface_from_text(radius + "*a", radius + "*b", "s", domain, definitions, Order::Second);
}

/// A torus whose section is a regular polygon, turned by `turns` of its corners on the way around.
Surface torus_of_polygon(int corners, int turns, const Domain& domain) {
  const std::string n = std::to_string(corners);
  const std::vector<Definition> definitions = {
      {"r", "cos(pi/" + n + ")/cos(mod(v,2*pi/" + n + ")-pi/" + n + ")"},
      {"w", "v+" + std::to_string(turns) + "*u/" + n}};
  return surface_from_text("(3+r*cos(w))*cos(u)", "(3+r*cos(w))*sin(u)", "r*sin(w)", domain,
                           definitions, Order::Second);
}

/// Expects a closed mesh within 1e-3 of the diagonal, with grid lines and without.
void expect_closed(const Surface& surface, long euler, const std::string& what) {
  for (const int lines : {0, 16}) {
    MeshRequest options = within_share(1e-3);
    options.lines = {lines, lines};
    const MeshResult result = try_mesh(surface, options).value();
    EXPECT_LE(result.report.max_error, result.report.tolerance) << what << ", lines " << lines;
    EXPECT_EQ(euler_number(result.mesh), euler) << what << ", lines " << lines;
    const auto counts = edge_counts(result.mesh);
    EXPECT_TRUE(std::ranges::all_of(counts, [](const auto& edge) { return edge.second == 2; }))
        << what << ", lines " << lines;
  }
}

TEST(Seams, OfSuperquadricsAreClosed) {
  for (const double exponent : {0.2, 0.5, 1.0, 2.5}) {
    for (const double first : {-kPi, 0.0}) {
      const std::string what = std::to_string(exponent) + " from " + std::to_string(first);
      const double last = first + kTwoPi;
      expect_closed(superquadric(exponent, {first, last, -kPi / 2, kPi / 2}, false), 2, what);
      expect_closed(superquadric(exponent, {first, last, first, last}, true), 0, "torus " + what);
    }
  }
}

TEST(Seams, OfTwistedPolygonsAreClosed) {
  for (const int corners : {3, 4, 5, 6}) {
    for (int turns = 0; turns < std::min(corners, 3); ++turns) {
      for (const double first : {-kPi, 0.0}) {
        expect_closed(
            torus_of_polygon(corners, turns, {first, first + kTwoPi, first, first + kTwoPi}), 0,
            std::to_string(turns) + " of " + std::to_string(corners));
      }
    }
  }
}

TEST(Seams, AreNotMadeWhereTheEdgeIsAJump) {
  // At u = 0 alone sign(u) is 0: the edges differ, and no rounding of u explains it.
  const Surface step = surface_from_text("cos(u)", "sin(u)", "v+0.01*sign(u)", {0, kTwoPi, -1, 1});
  EXPECT_EQ(mesh(step, 12, 4).report.closed_u, "");
}

TEST(GridLines, AreEvenlySpacedChainsOfMeshEdges) {
  const Mesh m = mesh(torus(), 30, 20, 16, 11).mesh;
  ASSERT_EQ(m.lines.size(), 16U + 11);
  const std::map<PointEdge, int> edges = edge_counts(m);
  for (std::size_t k = 0; k < m.lines.size(); ++k) {
    const std::vector<std::uint32_t>& line = m.lines[k];
    ASSERT_EQ(line.size(), k < 16 ? 21U : 31U);
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      EXPECT_TRUE(edges.contains(point_edge(m, line[i], line[i + 1])));
    }
    for (const std::uint32_t corner : line) {
      const double along = k < 16 ? m.uv[corner].x : m.uv[corner].y;
      const double part = k < 16 ? static_cast<double>(k) / 15 : static_cast<double>(k - 16) / 10;
      EXPECT_NEAR(along, kTwoPi * part, 1e-14);
    }
  }
}

TEST(GridLines, FollowTheNearestMeshLine) {
  const Mesh m = mesh(surface_from_text("u", "v", "u*v", {0, 1, 0, 1}), 10, 4, 4, 0).mesh;
  ASSERT_EQ(m.lines.size(), 4U);
  EXPECT_DOUBLE_EQ(m.uv[m.lines[0][0]].x, 0);
  EXPECT_DOUBLE_EQ(m.uv[m.lines[1][0]].x, 0.3);
  EXPECT_DOUBLE_EQ(m.uv[m.lines[2][0]].x, 0.7);
  EXPECT_DOUBLE_EQ(m.uv[m.lines[3][0]].x, 1);
}

TEST(GridLines, AreNoMoreThanMeshLines) {
  EXPECT_EQ(mesh(torus(), 3, 4, 100, 100).mesh.lines.size(), 4U + 5);
}

TEST(GridLines, BreakWhereTheSurfaceIsUndefined) {
  const Surface ring = surface_from_text("u", "v", "sqrt(u^2+v^2-0.25)", {});
  const Mesh m = mesh(ring, 20, 20, 3, 0).mesh;  // u = -1, 0, 1; the middle one crosses the hole
  ASSERT_EQ(m.lines.size(), 4U);
  const std::map<PointEdge, int> edges = edge_counts(m);
  for (const auto& line : m.lines) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      EXPECT_TRUE(edges.contains(point_edge(m, line[i], line[i + 1])));
    }
  }
  EXPECT_NEAR(m.uv[m.lines[1].back()].y, -0.5, 1e-15);
  EXPECT_NEAR(m.uv[m.lines[2].front()].y, 0.5, 1e-15);
}

TEST(GridLines, SkipAnEdgeBetweenTwoCellsThatAreLeftOut) {
  const Surface pricked =
      surface_from_text("u", "v", "0/((u+1)^2+v^2)+0/((u-1)^2+(v-1)^2)", {-2, 2, -2, 2});
  const Mesh m = mesh(pricked, 4, 4, 3, 0).mesh;  // undefined at (-1, 0) and at (1, 1)
  ASSERT_EQ(m.lines.size(), 5U);  // u = -2 and u = 0 in two parts each, a part of u = 2
  EXPECT_EQ(m.uv[m.lines[2].back()], dvec2(0, 0));
  EXPECT_EQ(m.uv[m.lines[3].front()], dvec2(0, 1));
}

TEST(GridLines, ReachThePolesAndAreNoneAtThem) {
  const Surface sphere =
      surface_from_text("cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)", {0, kTwoPi, 0, kPi});
  const Mesh m = mesh(sphere, 12, 8, 5, 3).mesh;
  ASSERT_EQ(m.lines.size(), 5U + 1);  // of the three parallels two are poles
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(m.lines[k].size(), 9U);
    EXPECT_EQ(m.position[m.lines[k].front()].z, 1);
    EXPECT_EQ(m.position[m.lines[k].back()].z, -1);
  }
}

TEST(GridLines, CanBeSwitchedOff) {
  EXPECT_TRUE(mesh(torus(), 4, 4).mesh.lines.empty());
}

}  // namespace
}  // namespace saddle
