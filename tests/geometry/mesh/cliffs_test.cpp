// Cliffs: parts of lines in which a continuous surface rises along a segment or a few, and the
// strips of triangles that show them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/vec.h"
#include "mesh/features/cliffs.h"
#include "mesh/mesher/mesh_plan.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/tree/cell_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kDelta = 1e-3;

/// The cliff along v = 0.1 from u = -1 to 1.
Cliff cliff_of(const char* z) {
  const Surface surface = height_field(z);
  const std::array<Line, 1> line = {{{dvec2(-1, 0.1), dvec2(1, 0.1)}}};
  std::size_t work = 0;
  return find_cliffs(surface, line, kDelta, 1, work)[0];
}

TEST(Cliffs, AreFoundFromFootToHead) {
  // z rises from u = 0.3 to 0.3001; a sheet may be left up to a sixteenth of delta on.
  const Cliff ramp = cliff_of("clamp(1e4*(u-0.3),0,1)");
  ASSERT_EQ(ramp.size(), 2U);
  EXPECT_NEAR(ramp[0].x, 0.3, 4e-6);
  EXPECT_NEAR(ramp[1].x, 0.3001, 4e-6);
  EXPECT_EQ(ramp[0].y, 0.1);
  // 1 - tanh(x) = delta/16 at x = 5.19.
  const Cliff smooth = cliff_of("tanh(1e5*(u-0.3))");
  ASSERT_EQ(smooth.size(), 2U);
  EXPECT_NEAR(smooth[0].x, 0.3 - 5.19e-5, 4e-6);
  EXPECT_NEAR(smooth[1].x, 0.3 + 5.19e-5, 4e-6);
}

TEST(Cliffs, AreFoundWholeWhereHalfOfOneRisesLikeItsSlopes) {
  // The line is halved on the cliff itself, at each of its places.
  const Surface wall = height_field("smoothstep(0,0.0003094,v)");
  std::vector<Line> lines;
  for (int k = 1; k < 1000; ++k) {
    const double middle = k * 0.0003094 / 1000;
    lines.push_back({dvec2(0, middle - 1.0 / 1920), dvec2(0, middle + 1.0 / 1920)});
  }
  std::size_t work = 0;
  for (const Cliff& cliff : find_cliffs(wall, lines, 0.003, 1, work)) {
    ASSERT_EQ(cliff.size(), 2U);
    EXPECT_NEAR(cliff[0].y, 0, 1e-5);
    EXPECT_NEAR(cliff[1].y, 0.0003094, 1e-5);
  }
}

TEST(Cliffs, AreNotSlopesWavesOrPoles) {
  for (const char* z :
       {"u", "u^2/2", "clamp(u,-0.9,0.9)", "sin(1e4*u)", "sin(40*u)", "1/(u-0.3)",
        "clamp(1e4*(u-0.3),0,1)+clamp(1e4*(u+0.6),0,1)+1e9*u^2", "clamp(1e4*(u-0.3),0,1e-4)"}) {
    EXPECT_TRUE(cliff_of(z).empty()) << z;
  }
}

/// The angle that a rounded edge of radius 0.1 turns by, 1.2 rad, while g grows by 1e-6.
std::string turned_where(const std::string& g) {
  return "clamp(1e6*(" + g + "),0,1.2)";
}

TEST(Cliffs, GoThroughVertices) {
  // Every vertex on the diagonal of the domain is in the middle of the wall.
  const MeshResult result =
      try_mesh(height_field("1/(1+exp(-1.485e5*(u-v)))"), within_share(1e-3)).value();
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_LT(result.mesh.triangles.size(), 1000U);
}

TEST(Cliffs, GoAroundEdgesInSegments) {
  const std::string angle = turned_where("u-0.3");
  const Surface surface =
      surface_from_text("u+0.1*sin(" + angle + ")", "v", "0.1-0.1*cos(" + angle + ")",
                        {-1, 1, -1, 1}, {}, Order::Second);
  const std::array<Line, 1> line = {{{dvec2(-1, 0.1), dvec2(1, 0.1)}}};
  std::size_t work = 0;
  const Cliff cliff = find_cliffs(surface, line, kDelta, 1, work)[0];
  // Chords that are a quarter of delta below an arc of radius 0.1 turn by 0.14 at most.
  EXPECT_GT(cliff.size(), 9U);
  EXPECT_LT(cliff.size(), 14U);
  EXPECT_NEAR(cliff.front().x, 0.3, 1e-6);
  EXPECT_NEAR(cliff.back().x, 0.3000012, 1e-6);
  const std::vector<dvec3> p = evaluate_positions(surface, cliff, 1);
  const dvec3 centre(0.3, 0.1, 0.1);
  for (std::size_t k = 1; k < p.size(); ++k)
    EXPECT_LT(0.1 - glm::distance(0.5 * (p[k - 1] + p[k]), centre), 0.26 * kDelta) << k;
}

TEST(Cliffs, AreSmoothStripsAroundEdges) {
  // The edge of a disc; what is around it has moved away by the edge's radius.
  const double radius = 0.69;
  const double most = 1.2;
  const std::string angle = turned_where("hypot(u,v)-0.69");
  const std::string stretched = "*(1+0.1*sin(" + angle + ")/max(hypot(u,v),0.1))";
  const Surface surface =
      surface_from_text("u" + stretched, "v" + stretched, "0.1-0.1*cos(" + angle + ")",
                        {-1, 1, -1, 1}, {}, Order::Second);
  const MeshResult result = try_mesh(surface, within_share(1e-3, 3)).value();
  const Mesh& mesh = result.mesh;
  EXPECT_LT(mesh.triangles.size(), 3000U);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  double farthest = 0;
  double most_turned = 0;
  const auto& position = mesh.position;
  for (const auto& t : mesh.triangles) {
    const dvec3 p = (position[t[0]] + position[t[1]] + position[t[2]]) / 3.0;
    const double r = std::hypot(p.x, p.y);
    // From the disc, the plane around it, and the arc between them.
    double nearest = std::hypot(std::max(0.0, r - radius), p.z);
    nearest = std::min(nearest, std::hypot(std::max(0.0, radius + 0.1 * std::sin(most) - r),
                                           p.z - 0.1 + 0.1 * std::cos(most)));
    const double on_arc = std::atan2(r - radius, 0.1 - p.z);
    if (on_arc >= 0 && on_arc <= most)
      nearest = std::min(nearest, std::fabs(std::hypot(r - radius, 0.1 - p.z) - 0.1));
    farthest = std::max(farthest, nearest);
    const dvec3 area = glm::cross(position[t[1]] - position[t[0]], position[t[2]] - position[t[0]]);
    if (!(glm::length(area) > 1e-7)) continue;  // slivers beside vertices on the edge
    for (const std::uint32_t k : t)
      most_turned = std::max(most_turned, degrees_between(glm::normalize(area), mesh.normal[k]));
  }
  EXPECT_LT(farthest, 1.05 * *result.report.tolerance);
  EXPECT_LT(most_turned, 20);
}

TEST(Cliffs, AreStripsOfFewTriangles) {
  for (const char* steepness : {"1e4", "1e8"}) {
    const std::string z = std::string("clamp(") + steepness + "*(u^2-v^2-0.1286),0,1)";
    const MeshResult result = try_mesh(height_field(z.c_str()), within_share(1e-3, 3)).value();
    const Mesh& mesh = result.mesh;
    EXPECT_LT(mesh.triangles.size(), 1500U) << z;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    // Edges in space, by position: all inner ones have two triangles.
    std::map<std::array<std::array<double, 3>, 2>, int> edges;
    const double rate = std::atof(steepness);
    double farthest = 0;
    std::size_t tilted = 0;
    const auto key = [&](std::uint32_t k) {
      const dvec3& p = mesh.position[k];
      return std::array{p.x, p.y, p.z};
    };
    for (const auto& t : mesh.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        std::array edge = {key(t[i]), key(t[(i + 1) % 3])};
        if (edge[1] < edge[0]) std::swap(edge[0], edge[1]);
        ++edges[edge];
      }
      const dvec3 middle = (mesh.position[t[0]] + mesh.position[t[1]] + mesh.position[t[2]]) / 3.0;
      // From the nearest of the two planes and of the wall between them.
      const double g = middle.x * middle.x - middle.y * middle.y - 0.1286;
      const double slope = 2 * std::hypot(middle.x, middle.y);
      const double from_wall = std::fabs(g - middle.z / rate) / slope;
      const double from_low = std::hypot(middle.z, std::max(0.0, g) / slope);
      const double from_high = std::hypot(1 - middle.z, std::max(0.0, 1 / rate - g) / slope);
      farthest = std::max(farthest, std::min({from_wall, from_low, from_high}));
      // Triangles of the planes have corners with the planes' normal.
      const bool is_flat = mesh.position[t[0]].z == mesh.position[t[1]].z &&
                           mesh.position[t[0]].z == mesh.position[t[2]].z;
      for (const std::uint32_t k : t) {
        if (is_flat && std::fabs(mesh.normal[k].z) < 0.999) ++tilted;
      }
    }
    EXPECT_LT(farthest, 1.05 * *result.report.tolerance) << z;
    EXPECT_EQ(tilted, 0U) << z;
    std::size_t open = 0;
    for (const auto& [edge, count] : edges) {
      const auto on_rim = [&](int axis) {
        return std::fabs(edge[0][axis]) == 1 && edge[0][axis] == edge[1][axis];
      };
      if (count != 2 && !on_rim(0) && !on_rim(1)) ++open;
    }
    EXPECT_EQ(open, 0U) << z;
  }
}

}  // namespace
}  // namespace saddle
