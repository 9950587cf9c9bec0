// Jump lines, their corners and their crossings: a mesh of flat sheets is compared with the formula
// as C++, in both directions, without any part of the mesher.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Of the tolerance: distances are sampled along chords, and the search below has steps.
constexpr double kAllowed = 1.1;

/// A surface of flat sheets.
struct Steps {
  const char* text;
  double end;  // of u and v, from -end
  std::function<double(double, double)> height;
};

double sign(double x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

const std::vector<Steps>& all_steps() {
  static const std::vector<Steps> steps = {
      {"sign(u*v)", 1, [](double u, double v) { return sign(u * v); }},
      {"(u>0&&v>0)?1:0", 1, [](double u, double v) { return u > 0 && v > 0 ? 1.0 : 0; }},
      {"floor(u)*floor(v)", 3, [](double u, double v) { return std::floor(u) * std::floor(v); }},
      {"(u>v)?((u>-v)?1:2):((u>-v)?3:4)", 1,
       [](double u, double v) { return u > v ? (u > -v ? 1.0 : 2) : (u > -v ? 3.0 : 4); }},
      {"(u^2+v^2<0.5&&v>0)?1:0", 1,
       [](double u, double v) { return u * u + v * v < 0.5 && v > 0 ? 1.0 : 0; }},
      {"sign(u^3-v^2)", 1, [](double u, double v) { return sign(u * u * u - v * v); }},
      {"round(3*sin(3*u)*sin(3*v))", 1,
       [](double u, double v) { return std::round(3 * std::sin(3 * u) * std::sin(3 * v)); }},
      {"floor(hypot(u,v))", 3, [](double u, double v) { return std::floor(std::hypot(u, v)); }},
      {"floor(5*sin(u*v))", 2, [](double u, double v) { return std::floor(5 * std::sin(u * v)); }}};
  return steps;
}

double distance_in_plane(const dvec2& p, const std::array<dvec2, 3>& t) {
  double least = std::numeric_limits<double>::infinity();
  int inside = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 a = t[k];
    const dvec2 way = t[(k + 1) % 3] - a;
    inside += way.x * (p.y - a.y) - way.y * (p.x - a.x) >= 0 ? 1 : -1;
    const double share = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
    least = std::min(least, glm::distance(p, a + share * way));
  }
  return std::abs(inside) == 3 ? 0 : least;
}

class JumpLines : public testing::TestWithParam<double> {
 protected:
  MeshResult mesh_of(const Steps& steps) {
    const double end = steps.end;
    return try_mesh(height_field(steps.text, {-end, end, -end, end}), within_share(GetParam()))
        .value();
  }
};

TEST_P(JumpLines, LieOnTheirSheetsWithinTheTolerance) {
  for (const Steps& steps : all_steps()) {
    const MeshResult result = mesh_of(steps);
    const double allowed = kAllowed * *result.report.tolerance;
    const auto is_on_sheet = [&](const dvec2& p, double height) {
      for (int ring = 0; ring <= 8; ++ring) {
        for (int way = 0; way < 32; ++way) {
          const double angle = (way + 0.37) * kPi / 16;
          const dvec2 q = p + allowed * ring / 8 * dvec2(std::cos(angle), std::sin(angle));
          if (steps.height(q.x, q.y) == height) return true;
        }
      }
      return false;
    };
    const auto& position = result.mesh.position;
    for (const Triangle& t : result.mesh.triangles) {
      ASSERT_EQ(position[t[0]].z, position[t[1]].z) << steps.text;
      ASSERT_EQ(position[t[0]].z, position[t[2]].z) << steps.text;
      for (std::size_t k = 0; k < 3; ++k) {
        const dvec2 middle = 0.5 * dvec2(position[t[k]] + position[t[(k + 1) % 3]]);
        ASSERT_TRUE(is_on_sheet(middle, position[t[0]].z))
            << steps.text << " at " << middle.x << ' ' << middle.y;
      }
    }
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << steps.text;
  }
}

TEST_P(JumpLines, LoseNoPartOfTheirSheets) {
  for (const Steps& steps : all_steps()) {
    const MeshResult result = mesh_of(steps);
    const double allowed = kAllowed * *result.report.tolerance;
    const auto& position = result.mesh.position;
    std::mt19937 dice(1);
    std::uniform_real_distribution<double> place(-steps.end, steps.end);
    for (int k = 0; k < 1000; ++k) {
      const dvec2 p(place(dice), place(dice));
      const double height = steps.height(p.x, p.y);
      const bool is_near = std::ranges::any_of(result.mesh.triangles, [&](const Triangle& t) {
        return position[t[0]].z == height &&
               distance_in_plane(p, {dvec2(position[t[0]]), dvec2(position[t[1]]),
                                     dvec2(position[t[2]])}) <= allowed;
      });
      ASSERT_TRUE(is_near) << steps.text << " at " << p.x << ' ' << p.y;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Tolerances, JumpLines, testing::Values(1e-2, 1e-3));

TEST(JumpCorners, OfTwoSteepBoundariesAreVertices) {
  // sqrt(1e-6) is a thousandth: chords across the corner would miss the height above it.
  const struct {
    const char* text;
    double end;
    dvec3 corner;
  } cases[] = {{"sqrt(u)+sqrt(v)", 1, {0, 0, 0}},
               {"sqrt(1-u^2)+sqrt(1-v^2)", 2, {1, 1, 0}},
               {"acos(u)*acos(v)", 2, {-1, -1, kPi * kPi}}};
  for (const auto& [text, end, corner] : cases) {
    const MeshResult result =
        try_mesh(height_field(text, {-end, end, -end, end}), within_share(1e-3)).value();
    double nearest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : result.mesh.triangles) {
      for (const std::uint32_t k : t)
        nearest = std::min(nearest, glm::distance(result.mesh.position[k], corner));
    }
    EXPECT_LE(nearest, *result.report.tolerance) << text;
  }
}

TEST(JumpCrossings, AreSolvedForWithoutMoreCells) {
  // Both lines run along sides of cells.
  const MeshResult crossing = try_mesh(height_field("sign(u*v)"), within_share(1e-4)).value();
  const MeshResult one = try_mesh(height_field("sign(u)"), within_share(1e-4)).value();
  EXPECT_LE(crossing.report.cells, one.report.cells + 32);
}

TEST(JumpLinesAlongSides, HaveNoTrianglesBetweenThemAndFinerNeighbours) {
  // The upper sheet ends in a cusp along v = 0, for which its cells are halved.
  const MeshResult result =
      try_mesh(height_field("if(v<0,1,cbrt(u^2+v))"), within_share(1e-3)).value();
  const auto& uv = result.mesh.uv;
  for (const Triangle& t : result.mesh.triangles) {
    const dvec2 a = uv[t[1]] - uv[t[0]];
    const dvec2 b = uv[t[2]] - uv[t[0]];
    EXPECT_GT(a.x * b.y - a.y * b.x, 1e-12) << uv[t[0]].x << ", " << uv[t[0]].y;
  }
}

}  // namespace
}  // namespace saddle
