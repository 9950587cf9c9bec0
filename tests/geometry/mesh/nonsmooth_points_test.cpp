// Points without tangents: the apexes of cones.
#include "mesh/features/nonsmooth_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh_requests.h"
#include "surface/normal.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

TEST(NonsmoothPoints, AreTheApexesOfCones) {
  for (const auto& [z, u, v] :
       {std::tuple("hypot(u,v)", 0.0, 0.0), std::tuple("sqrt(u^2+v^2)", 0.0, 0.0),
        std::tuple("1e-6*hypot(u-0.1,v+0.3)", 0.1, -0.3), std::tuple("hypot(u,v-1)", 0.0, 1.0),
        std::tuple("(u^2+v^2)/hypot(u,v)", 0.0, 0.0)}) {
    EXPECT_EQ(find_nonsmooth_points(height_field(z), 1, 1).conical, std::vector{dvec2(u, v)}) << z;
  }
  // No end of a halved range is 0.
  EXPECT_EQ(find_nonsmooth_points(height_field("hypot(u,v)", {-1, 2, -0.3, 1}), 1, 1).conical,
            std::vector{dvec2(0)});
  EXPECT_EQ(find_nonsmooth_points(height_field("hypot(u,v)*hypot(u-0.5,v)"), 1, 1).conical.size(),
            2U);
}

TEST(NonsmoothPoints, AreTipsWithinAndBesideCreases) {
  for (const auto& [z, u, v] :
       {std::tuple("max(0,1-hypot(u-0.3,v-0.1)/3e-5)", 0.3, 0.1),
        std::tuple("min(1,hypot(u-0.45446,v-0.642386)/0.000277)", 0.45446, 0.642386),
        std::tuple("hypot(u-0.3,v-0.1)+abs(u+v)", 0.3, 0.1)}) {
    EXPECT_EQ(find_nonsmooth_points(height_field(z), 1, 1).conical, std::vector{dvec2(u, v)}) << z;
  }
}

/// Each of these has tangents at the doubles beside the points.
TEST(NonsmoothPoints, AreFoundBetweenDoubles) {
  const auto conical = [](const char* z) {
    return find_nonsmooth_points(height_field(z, {-3, 3, -3, 3}), 5, 1).conical;
  };
  const std::vector<dvec2> cones = conical("hypot(u^2-2,v)");
  ASSERT_EQ(cones.size(), 2U);
  for (const dvec2& uv : cones) {
    EXPECT_NEAR(std::fabs(uv.x), std::numbers::sqrt2, 1e-15);
    EXPECT_EQ(uv.y, 0);
  }
  // The pursuit of the double zero at (0, 0) takes many boxes.
  EXPECT_EQ(conical("sqrt(hypot(v^2-4.2*u,sin(v^2)))").size(), 5U);
  for (const char* const z : {"sqrt(1e-9+hypot(u^2-2,v)^2)", "1/((u^2-2)^2+v^2)",
                              "(u^2-2)*v/((u^2-2)^2+v^2)", "sin(hypot(u^2-2,v))/hypot(u^2-2,v)"}) {
    EXPECT_TRUE(conical(z).empty()) << z;
  }
}

TEST(NonsmoothPoints, AreWhereCreasesCross) {
  const auto at = [](double u, double v) {
    return [u, v](const dvec2& uv) { return glm::distance(uv, dvec2(u, v)) < 1e-12; };
  };
  for (const char* const z : {"abs(u-0.1)^0.3+abs(v-0.2)^0.3", "sqrt(abs(u-0.1)+abs(v-0.2))",
                              "abs(u-0.1)+abs(v-0.2)", "max(u-0.1,0)+abs(u+v-0.3)"}) {
    const std::vector<dvec2> points = find_nonsmooth_points(height_field(z), 2, 1).conical;
    ASSERT_EQ(points.size(), 1U) << z;
    EXPECT_TRUE(at(0.1, 0.2)(points[0])) << z;
  }
  // No lines of constant u or v, and a place that no double has.
  const std::vector<dvec2> points =
      find_nonsmooth_points(height_field("(abs(u+0.3*v-0.1)+abs(v-0.2-0.4*u))^0.3"), 2, 1).conical;
  ASSERT_EQ(points.size(), 1U);
  EXPECT_TRUE(at(0.04 / 1.12, 0.24 / 1.12)(points[0]));
  // A crease alone, a jump, and the corner of a domain hold none.
  for (const char* const z : {"abs(u-0.3*v)^0.3", "floor(3*u)+abs(v)", "sqrt(u-0.1)+sqrt(v-0.2)"})
    EXPECT_TRUE(find_nonsmooth_points(height_field(z), 2, 1).conical.empty()) << z;
}

/// The sheets of atan2(v, u) reach to heights of -pi and pi at the end of its jump.
TEST(NonsmoothPoints, AreReachedByTheSheetsOfAJumpThatEndsThere) {
  const double tolerance = 3.5e-3;
  const MeshResult mesh = try_mesh(height_field("atan2(v,u)/3"), within_length(tolerance)).value();
  for (const double height : {-std::numbers::pi / 3, std::numbers::pi / 3}) {
    double nearest = 1;
    for (const dvec3& p : mesh.mesh.position)
      nearest = std::min(nearest, glm::distance(p, dvec3(0, 0, height)));
    EXPECT_LE(nearest, tolerance) << height;
  }
}

TEST(NonsmoothPoints, AreNoneOnLinesAndInHoles) {
  for (const char* const z :
       {"u*v", "abs(u)", "floor(3*u)", "1/(u^2+v^2)", "atan2(v,u)", "u*v/(u^2+v^2)",
        "sqrt(0.5-u^2-v^2)", "tan(3*u)", "sin(hypot(u,v))/hypot(u,v)"}) {
    EXPECT_TRUE(find_nonsmooth_points(height_field(z), 1, 1).conical.empty()) << z;
  }
}

TEST(NonsmoothPoints, AreNoLimitsOfWaysThatLeadElsewhere) {
  const Surface without_limit = height_field("(u-0.125)*(v+0.375)/((u-0.125)^2+(v+0.375)^2)");
  EXPECT_EQ(find_nonsmooth_points(without_limit, 3, 1).without_limit,
            std::vector{dvec2(0.125, -0.375)});
  for (const char* const z : {"sin(hypot(u,v))/hypot(u,v)", "hypot(u,v)"}) {
    EXPECT_TRUE(find_nonsmooth_points(height_field(z), 3, 1).without_limit.empty()) << z;
  }
  // Beside a line of the grid, too, which is 0.008 away here.
  const MeshResult mesh = try_mesh(without_limit, within_length(3e-3)).value();
  EXPECT_LE(mesh.report.max_error, 3e-3);
  ASSERT_EQ(mesh.report.without_limit.size(), 1U);
  EXPECT_EQ(mesh.report.without_limit[0], dvec2(0.125, -0.375));
  EXPECT_EQ(mesh.report.singular_point_count, 0U);
}

TEST(NonsmoothPoints, ArePolesOnLinesOfJumps) {
  for (const char* const z : {"1/(u^2+v^2)", "sign(v)+0.1/hypot(u,v)", "(u>v?1:2)/hypot(u,v)"}) {
    EXPECT_EQ(find_nonsmooth_points(height_field(z), 3, 1).without_limit, std::vector{dvec2(0)})
        << z;
  }
}

/// Normals of a cone of 45 degrees are as exact beside its apex as elsewhere.
TEST(NonsmoothPoints, AreVerticesWithTheNormalOfEachSide) {
  const Surface surface = height_field("hypot(u-0.1,v+0.3)");
  const MeshResult mesh = try_mesh(surface, within_length(1e-2)).value();
  EXPECT_EQ(mesh.report.singular_point_count, 1U);
  std::size_t corners = 0;
  for (std::size_t k = 0; k < mesh.mesh.uv.size(); ++k) {
    if (mesh.mesh.uv[k] != dvec2(0.1, -0.3)) continue;
    ++corners;
    EXPECT_NEAR(mesh.mesh.normal[k].z, std::sqrt(0.5), 1e-9);
  }
  EXPECT_GE(corners, 4U);
}

/// So they are between doubles. The slopes of the tip along u are 2 * sqrt(2), those along v 1.
TEST(NonsmoothPoints, AreVerticesWithTheNormalOfEachSideBetweenDoubles) {
  const Surface surface = height_field("hypot(u^2-2,v-0.1)", {0.5, 3, -3, 3});
  const MeshResult mesh = try_mesh(surface, within_length(1e-2)).value();
  ASSERT_EQ(mesh.report.singular_point_count, 1U);
  std::vector<dvec3> normals;
  for (std::size_t k = 0; k < mesh.mesh.uv.size(); ++k) {
    if (glm::distance(mesh.mesh.uv[k], dvec2(std::numbers::sqrt2, 0.1)) > 1e-12) continue;
    EXPECT_NEAR(mesh.mesh.position[k].z, 0, 1e-12);
    normals.push_back(mesh.mesh.normal[k]);
  }
  ASSERT_GE(normals.size(), 4U);
  const auto slope = [](const dvec3& n) { return glm::length(dvec2(n)) / n.z; };
  for (const dvec3& n : normals) {
    EXPECT_GE(slope(n), 1 - 1e-6);
    EXPECT_LE(slope(n), 2 * std::numbers::sqrt2 + 1e-6);
  }
  const auto [least, most] = std::ranges::minmax(normals, {}, [](const dvec3& n) { return n.y; });
  EXPECT_LT(least.y, -0.25);
  EXPECT_GT(most.y, 0.25);
}

}  // namespace
}  // namespace saddle
