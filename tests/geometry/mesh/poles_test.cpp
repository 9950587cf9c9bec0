// Where a surface goes to infinity, no triangle has corners on both sides, whichever way the line
// of its poles runs through the cells, and however wide the tolerance is there.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/random.h"
#include "mesh/features/approach.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// The denominator: at its zeros are the poles.
using Denominator = double (*)(double u, double v);

struct PoleCase {
  const char* z;
  Denominator denominator;
};

const std::vector<PoleCase> kAslant = {
    {"1/(u-0.3*v)", [](double u, double v) { return u - 0.3 * v; }},
    {"1/(u-v^2)", [](double u, double v) { return u - v * v; }},
    {"1/(u^2+v^2-0.25)", [](double u, double v) { return u * u + v * v - 0.25; }},
    {"1/(u*v-0.1)", [](double u, double v) { return u * v - 0.1; }},
    {"1/(u+v-0.3*sin(3*u))", [](double u, double v) { return u + v - 0.3 * std::sin(3 * u); }},
    {"1/(u-v^2)^2", [](double u, double v) { return u - v * v; }},
    {"ln(abs(u-v^2))", [](double u, double v) { return u - v * v; }}};

const std::vector<PoleCase> kBesideRims = {
    {"sqrt(1-u^2-v^2)/(u-0.3)", [](double u, double) { return u - 0.3; }},
    {"sqrt(1-u^2-v^2)/(u-0.1)", [](double u, double) { return u - 0.1; }},
    {"sqrt(1-u^2-v^2)/(u-0.3*v)", [](double u, double v) { return u - 0.3 * v; }}};

MeshRequest options() {
  return within_share(1e-3);
}

/// Triangles with corners on both sides of the poles.
std::size_t walls(const Mesh& mesh, Denominator denominator) {
  constexpr double kOnPole = 1e-13;
  std::size_t count = 0;
  for (const Triangle& t : mesh.triangles) {
    double least = 0;
    double most = 0;
    for (const std::uint32_t corner : t) {
      const double side = denominator(mesh.uv[corner].x, mesh.uv[corner].y);
      least = std::min(least, side);
      most = std::max(most, side);
    }
    if (least < -kOnPole && most > kOnPole) ++count;
  }
  return count;
}

TEST(Poles, AslantOrCurvedAreCutWithoutABox) {
  for (const PoleCase& c : kAslant) {
    const MeshResult result = try_mesh(height_field(c.z), options()).value();
    EXPECT_EQ(walls(result.mesh, c.denominator), 0U) << c.z;
    EXPECT_GT(result.report.pole_count, 0U) << c.z;
    EXPECT_GT(area_in_uv(result.mesh), 0.85 * 4) << c.z;
  }
}

TEST(Poles, AslantOrCurvedAreCutOutOfSamples) {
  struct Cells {
    std::size_t u, v;
  };
  for (const PoleCase& c : kAslant) {
    for (const Cells cells : {Cells{20, 20}, Cells{10, 10}, Cells{7, 9}}) {
      const MeshResult result =
          try_mesh(height_field(c.z), with_samples(options(), cells.u, cells.v)).value();
      EXPECT_EQ(walls(result.mesh, c.denominator), 0U) << c.z << ' ' << cells.u;
      // The poles are no longer than 4.5, and cross each row and column in at most two cells.
      const double crossed = 4.0 / static_cast<double>(cells.u * cells.v);
      const auto most = static_cast<double>(2 * (cells.u + cells.v));
      EXPECT_GT(area_in_uv(result.mesh), 4 - most * crossed) << c.z << ' ' << cells.u;
    }
  }
}

TEST(Poles, AreCutWhereTheLimitOfTrianglesEndsTheMesh) {
  for (const std::size_t most : {300U, 1000U, 3000U}) {
    MeshRequest limited = options();
    limited.max_triangles = most;
    for (const PoleCase& c : kAslant) {
      const MeshResult result = try_mesh(height_field(c.z), limited).value();
      EXPECT_EQ(walls(result.mesh, c.denominator), 0U) << c.z << ' ' << most;
    }
  }
}

TEST(Poles, ThatMeetARimAreCutThere) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  MeshRequest clipped = options();
  clipped.tolerance = [](const Probe&) -> Tolerance { return 0.0078; };
  clipped.clip = Bounds{dvec3(-kFar, -kFar, -4), dvec3(kFar, kFar, 3)};
  for (const PoleCase& c : kBesideRims) {
    const Surface surface = height_field(c.z);
    const std::vector<MeshResult> meshes = {
        try_mesh(surface, options()).value(),
        try_mesh(surface, clipped).value(),
        try_mesh(surface, with_samples(options(), 20, 20)).value(),
        try_mesh(surface, with_samples(clipped, 20, 20)).value(),
    };
    for (std::size_t k = 0; k < meshes.size(); ++k) {
      EXPECT_EQ(walls(meshes[k].mesh, c.denominator), 0U) << c.z << ' ' << k;
    }
  }
}

TEST(Poles, AreNoneWhereBoundsKeepTheSurfaceNear) {
  std::vector<Line> ways;  // to places on both axes
  for (std::uint64_t k = 0; k < 40000; ++k) {
    const double place = 2 * random_unit(2 * k) - 1;
    const double way = 0.1 * random_unit(2 * k + 1);
    ways.push_back({dvec2(0, place), dvec2(way, place + way)});
    ways.push_back({dvec2(place, 0), dvec2(place, way)});
  }
  const auto count = [&](const char* z) {
    return std::ranges::count(diverge(height_field(z), ways, 2e-3, 1), true);
  };
  // Six looks at what oscillates may well seem to go somewhere.
  for (const char* z : {"cos(1/(u*v))", "sin(1/u)*sin(1/v)", "atan(1/v)*sin(1/u)"}) {
    EXPECT_EQ(count(z), 0) << z;
  }
  for (const char* z : {"1/(u*v)", "ln(abs(u*v))", "abs(u*v)^(-0.05)"}) {
    EXPECT_EQ(count(z), static_cast<long>(ways.size())) << z;
  }
}

TEST(Poles, AreNoneWhereASteepSurfaceIsBounded) {
  // Within a double of 0.2 the first goes from -0.16 to 0.16.
  for (const char* z : {"sign(u-0.2)*abs(u-0.2)^0.05", "abs(u-0.2)^0.05", "abs(u-v/3)^0.03"}) {
    const MeshResult result = try_mesh(height_field(z), options()).value();
    EXPECT_EQ(result.report.pole_count, 0U) << z;
    EXPECT_EQ(result.report.jump_count, 0U) << z;
  }
}

TEST(Poles, AreNoneWhereRadiiJump) {
  const std::string radius = "(mod(floor(5*u)+floor(5*v),2)>0.5?1:0.9)*";
  const Surface checkered =
      surface_from_text(radius + "cos(u)*sin(v)", radius + "sin(u)*sin(v)", radius + "cos(v)",
                        {0, 2 * kPi, 0, kPi}, {}, Order::Second);
  EXPECT_EQ(try_mesh(checkered, options()).value().report.pole_count, 0U);
}

TEST(Poles, HaveFiniteVerticesBesideThem) {
  for (const char* z : {"0.3*v+1e-4*ln(abs(u-0.378522))", "0.3*v+1e-6*ln(abs(u-0.378522))",
                        "0.3*v+1e-4*ln(abs(u-0.5))", "1e-5*ln(abs(u-0.2*v))",
                        "1e-4*ln(hypot(u-0.25,v-0.378522))"}) {
    const MeshResult result = try_mesh(height_field(z), options()).value();
    EXPECT_TRUE(std::ranges::all_of(result.mesh.position, is_finite)) << z;
    EXPECT_GT(result.mesh.triangles.size(), 0U) << z;
  }
}

/// The largest distance of places on triangles from a surface whose level lines are straight:
/// `from_line` is the distance of (x, y) from that of a height.
template <class FromLine>
double distance_from_lines(const Mesh& mesh, double reach, FromLine from_line) {
  constexpr int kParts = 6;    // of each side of a triangle
  constexpr int kHeights = 8;  // up and down
  double most = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int a = 0; a <= kParts; ++a) {
      for (int b = 0; a + b <= kParts; ++b) {
        const dvec3 p = (static_cast<double>(a) * mesh.position[t[0]] +
                         static_cast<double>(b) * mesh.position[t[1]] +
                         static_cast<double>(kParts - a - b) * mesh.position[t[2]]) /
                        static_cast<double>(kParts);
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = -kHeights; k <= kHeights; ++k) {
          const double up = reach * k / kHeights;
          nearest = std::min(nearest, std::hypot(from_line(p, p.z + up), up));
        }
        most = std::max(most, nearest);
      }
    }
  }
  return most;
}

TEST(Poles, HaveNoTrianglesAcrossThemWhereTheSurfaceIsZero) {
  // z = u/v: the line u = z v. z = (u+v)/(u-v): the line u (1-z) + v (1+z) = 0.
  constexpr double kTolerance = 0.01;
  // The largest error may lie between validation points.
  constexpr double kMost = 1.05 * kTolerance;
  MeshRequest request = within_length(kTolerance);
  request.clip = Bounds{dvec3(-2, -2, -5), dvec3(2, 2, 5)};
  const Domain domain = {-2, 2, -2, 2};
  const auto ratio = [](const dvec3& p, double z) { return (p.x - z * p.y) / std::hypot(1, z); };
  const auto sums = [](const dvec3& p, double z) {
    return (p.x * (1 - z) + p.y * (1 + z)) / std::hypot(1 - z, 1 + z);
  };
  const Mesh of_ratio = try_mesh(height_field("u/v", domain), request).value().mesh;
  EXPECT_LT(distance_from_lines(of_ratio, kTolerance, ratio), kMost);
  const Mesh of_sums = try_mesh(height_field("(u+v)/(u-v)", domain), request).value().mesh;
  EXPECT_LT(distance_from_lines(of_sums, kTolerance, sums), kMost);
}

TEST(Poles, HaveNoTrianglesAcrossThemWhereTheyChangeTheirSign) {
  // z = (u+0.9887v)/(u-v): the line u (1-z) + v (0.9887+z) = 0.
  constexpr double kTolerance = 0.0085;
  constexpr double kMost = 1.05 * kTolerance;
  MeshRequest request = within_length(kTolerance);
  request.clip = Bounds{dvec3(-2, -2, -3.95), dvec3(2, 2, 4.05)};
  const auto sums = [](const dvec3& p, double z) {
    return (p.x * (1 - z) + p.y * (0.9887 + z)) / std::hypot(1 - z, 0.9887 + z);
  };
  const Mesh of_sums = try_mesh(height_field("(u+0.9887*v)/(u-v)"), request).value().mesh;
  EXPECT_LT(distance_from_lines(of_sums, kTolerance, sums), kMost);
}

TEST(Poles, HaveNoTrianglesAcrossThemWhereRegionsEnd) {
  // The pole's line goes through the corner of a region, or a jump begins on it.
  const std::vector<PoleCase> cases = {
      {"(u>0&&v>0)?1/(u-v):nan", [](double u, double v) { return u - v; }},
      {"(u<0.5&&v>0)?1/(u+v-0.5):nan", [](double u, double v) { return u + v - 0.5; }},
      {"(u>0&&v>0)?v/(u-v):0", [](double u, double v) { return u > 0 && v > 0 ? u - v : 0; }}};
  MeshRequest request = within_length(0.0067);
  request.clip = Bounds{dvec3(-2, -2, -3.3), dvec3(2, 2, 3.4)};
  for (const auto& [z, denominator] : cases)
    EXPECT_EQ(walls(try_mesh(height_field(z), request).value().mesh, denominator), 0U) << z;
}

TEST(Poles, LeaveNothingOutWhereTheSurfaceCrossesZero) {
  // z = v/(4u): the line v = 4 z u. z = v/sin(4u): the curve v = z sin(4u).
  constexpr double kTolerance = 0.0037;
  constexpr double kFace = 1.25;
  MeshRequest request = within_length(kTolerance);
  request.clip = Bounds{dvec3(-2, -2, -kFace), dvec3(2, 2, kFace)};
  const Mesh of_line = try_mesh(height_field("v/(4*u)"), request).value().mesh;
  const Mesh of_sine = try_mesh(height_field("v/sin(4*u)"), request).value().mesh;
  const TriangleTree line(of_line);
  const TriangleTree sine(of_sine);
  double from_line = 0;
  double from_sine = 0;
  for (int level = -49; level <= 49; ++level) {
    const double z = kFace * level / 49.5;
    for (int step = -100; step <= 100; ++step) {
      const double u = 1e-4 * (step + 0.5);
      from_line = std::max(from_line, line.distance({u, 4 * z * u, z}));
      from_sine = std::max(from_sine, sine.distance({u, z * std::sin(4 * u), z}));
    }
  }
  EXPECT_LE(from_line, kTolerance);
  EXPECT_LE(from_sine, kTolerance);
}

TEST(Poles, AreToldFromJumpsWhereRoundingEndsTheWayToThem) {
  // 1 + cos(u) is 0, or a few steps from there, within 1e-8 of pi.
  const Line way = {dvec2(kPi, 0.1), dvec2(3.4, 0.1)};
  const Domain domain = {-5, 5, -5, 5};
  EXPECT_TRUE(diverge(height_field("1/(1+cos(u))", domain), std::span(&way, 1), 1e-2, 1)[0]);
  // The logarithm ends as near to its pole, where a search may take its last step for a jump.
  const Line to_step = {dvec2(1, kPi / 2 - 1 + 5e-8), dvec2(1.01, kPi / 2 - 1 + 5e-8)};
  for (const char* z : {"ln(1-sin(u+v))", "ln(abs(sec(u+v)+tan(u+v)))", "atanh(sin(u+v))"})
    EXPECT_TRUE(diverge(height_field(z, domain), std::span(&to_step, 1), 1e-2, 1)[0]) << z;
  for (const char* z : {"(1-sin(u+v))^.05", "ln(1.0000001-sin(u+v))"})
    EXPECT_FALSE(diverge(height_field(z, domain), std::span(&to_step, 1), 1e-2, 1)[0]) << z;
  const Line to_peak = {dvec2(0, 0.1), dvec2(0.3, 0.1)};
  EXPECT_FALSE(diverge(height_field("1/(u^2+1e-8)"), std::span(&to_peak, 1), 1e-2, 1)[0]);
  MeshRequest options = within_share(1e-3, 3);
  const MeshResult result = try_mesh(height_field("1/(1+cos(u)*cos(v))", domain), options).value();
  EXPECT_GT(result.report.pole_count, 0U);
  EXPECT_EQ(result.report.jump_count, 0U);
}

TEST(Poles, AreLeftOut) {
  const MeshResult result = try_mesh(height_field("ln(u)"), within_share(1e-3)).value();
  EXPECT_GT(result.mesh.bounds.low.z, -50);
  EXPECT_NEAR(result.report.undefined_fraction, 0.5, 0.02);
}

TEST(Poles, AtARimTakeNoEndlessWork) {
  const MeshResult result =
      try_mesh(height_field("ln(cos(v)/cos(u))", {-5, 5, -5, 5}), within_share(1e-3)).value();
  EXPECT_GT(result.report.pole_count, 0U);
  EXPECT_LT(result.mesh.triangles.size(), 100'000U);
}

TEST(Poles, OnCurvesTakeNoEndlessWork) {
  for (const char* z : {"1/(u-v)", "1/(u^2+v^2-0.5)"}) {
    MeshRequest options = within_share(1e-3, 3);
    options.clip = Bounds{dvec3(-2, -2, -9), dvec3(2, 2, 9)};
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_GT(result.report.pole_count, 0U) << z;
    EXPECT_LT(result.mesh.triangles.size(), 50'000U) << z;
  }
}

TEST(Poles, AreCutWhereTheyAre) {
  const MeshResult result =
      try_mesh(height_field("tan(u)", {-3, 3, -1, 1}), within_share(1e-3)).value();
  EXPECT_GT(result.report.pole_count, 0U);
  for (const dvec2& pole : result.report.poles) EXPECT_NEAR(std::fabs(pole.x), kPi / 2, 1e-12);
  for (const Triangle& t : result.mesh.triangles) {
    const auto u = [&](std::size_t k) { return std::fabs(result.mesh.uv[t[k]].x); };
    const bool below = u(0) < kPi / 2;
    ASSERT_EQ(u(1) < kPi / 2, below);
    ASSERT_EQ(u(2) < kPi / 2, below);
  }
}

TEST(Poles, ThatAreTheSameFromAllSidesAreNoLimits) {
  for (const char* z : {"1/(u^2+v^2)", "-1/hypot(u,v)", "ln(u^2+v^2)"}) {
    EXPECT_GT(try_mesh(height_field(z), within_share(1e-3)).value().report.pole_count, 0U) << z;
  }
}

/// A vertex on a pole is at a finite place by rounding alone, 1e17 away: no error is measured
/// there.
TEST(Poles, NeedlesToThemAreLeftOut) {
  for (const char* z : {"1/(u+v)", "1/(u-v^2)", "1/(u-v)^2"}) {
    MeshRequest options = within_length(10);
    options.lines = {31, 31};  // at -0.2 and 0.2, where sums have rounding left
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_LE(result.report.max_error, 10) << z;
    EXPECT_LT(result.mesh.bounds.diagonal(), 1e13) << z;
  }
}

}  // namespace
}  // namespace saddle
