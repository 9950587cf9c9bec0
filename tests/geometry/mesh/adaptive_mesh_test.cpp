// Meshes within a tolerance: they keep it, everywhere, without cracks and without waste.
#include "mesh/mesher/mesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/random.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/mesh_report.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

struct Case {
  const char* name;
  const char* x;
  const char* y;
  const char* z;
  Domain domain;
};

const std::vector<Case>& cases() {
  static const std::vector<Case> kCases = {
      {"sphere", "cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)", {0, 2 * kPi, -kPi / 2, kPi / 2}},
      {"torus", "(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", {0, 2 * kPi, 0, 2 * kPi}},
      {"catenoid", "cosh(v)*cos(u)", "cosh(v)*sin(u)", "v", {0, 2 * kPi, -1, 1}},
      {"helicoid", "v*cos(u)", "v*sin(u)", "u", {0, 2 * kPi, -1, 1}},
      {"enneper", "u-u^3/3+u*v^2", "v-v^3/3+u^2*v", "u^2-v^2", {-1.5, 1.5, -1.5, 1.5}},
      {"monkey", "u", "v", "u^3-3*u*v^2", {-1, 1, -1, 1}},
      {"peak", "u", "v", "exp(-40*((u-0.3)^2+(v+0.2)^2))", {-1, 1, -1, 1}},
      {"figure-8",
       "(2+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*cos(u)",
       "(2+cos(u/2)*sin(v)-sin(u/2)*sin(2*v))*sin(u)",
       "sin(u/2)*sin(v)+cos(u/2)*sin(2*v)",
       {0, 2 * kPi, 0, 2 * kPi}},
      {"mobius",
       "(1+v*cos(u/2))*cos(u)",
       "(1+v*cos(u/2))*sin(u)",
       "v*sin(u/2)",
       {0, 2 * kPi, -0.4, 0.4}},
      {"ripple", "u", "v", "sin(9*sqrt(u^2+v^2+0.1))/9", {-2, 2, -2, 2}},
  };
  return kCases;
}

Surface surface_of(const Case& c) {
  return surface_from_text(c.x, c.y, c.z, c.domain, {}, Order::Second);
}

MeshResult mesh_of(const Case& c, double share, double normal_tolerance = 180) {
  return try_mesh(surface_of(c), within_share(share, normal_tolerance)).value();
}

/// Finds the triangle above a point of the (u, v) plane.
class Locator {
 public:
  explicit Locator(const Mesh& mesh) : mesh_(mesh) {
    for (const dvec2& uv : mesh.uv) {
      low_ = glm::min(low_, uv);
      high_ = glm::max(high_, uv);
    }
    for (const Triangle& t : mesh.triangles) {
      dvec2 low = mesh.uv[t[0]];
      dvec2 high = low;
      for (const std::uint32_t corner : t) {
        low = glm::min(low, mesh.uv[corner]);
        high = glm::max(high, mesh.uv[corner]);
      }
      const auto [a, b] = std::pair(bin(low), bin(high));
      for (int j = a.second; j <= b.second; ++j) {
        for (int i = a.first; i <= b.first; ++i) bins_[{i, j}].push_back(t);
      }
    }
  }

  /// The point of the mesh at (u, v), if a triangle is there.
  std::optional<dvec3> at(const dvec2& uv) const {
    const auto found = bins_.find(bin(uv));
    if (found == bins_.end()) return std::nullopt;
    for (const Triangle& t : found->second) {
      const auto area = [](const dvec2& a, const dvec2& b, const dvec2& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
      };
      const auto [a, b, c] = std::array{mesh_.uv[t[0]], mesh_.uv[t[1]], mesh_.uv[t[2]]};
      const double whole = area(a, b, c);
      const dvec3 w = dvec3(area(uv, b, c), area(a, uv, c), area(a, b, uv)) / whole;
      constexpr double kEdge = -1e-12;  // on the edge between two
      if (w.x < kEdge || w.y < kEdge || w.z < kEdge) continue;
      return w.x * mesh_.position[t[0]] + w.y * mesh_.position[t[1]] + w.z * mesh_.position[t[2]];
    }
    return std::nullopt;
  }

  /// The distance to the nearest triangle of all.
  double nearest(const SurfacePoint& point) const {
    Grid grid;
    grid.mesh = mesh_;
    double least = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh_.triangles) {
      least =
          std::min(least, sampled_error(grid, std::span(&t, 1), dvec2(0), point, false).distance);
    }
    return least;
  }

 private:
  static constexpr int kBins = 64;
  std::pair<int, int> bin(const dvec2& uv) const {
    const dvec2 part = (uv - low_) / (high_ - low_) * double(kBins);
    return {static_cast<int>(part.x), static_cast<int>(part.y)};
  }
  const Mesh& mesh_;
  dvec2 low_{1e300}, high_{-1e300};
  std::map<std::pair<int, int>, std::vector<Triangle>> bins_;
};

/// Distance of a point from the part of the mesh near (u, v): to the plane of the tangents there,
/// which is what sliding along the surface leaves.
double distance(const Locator& mesh, const SurfacePoint& point, const dvec2& uv) {
  const std::optional<dvec3> on_mesh = mesh.at(uv);
  if (!on_mesh) return mesh.nearest(point);  // half of a cell at a pole is a point in space
  const dvec3 off = *on_mesh - point.position;
  const dvec3 cross = glm::cross(point.r_u, point.r_v);
  const double length = glm::length(cross);
  if (!(length > 1e-6 * glm::length(point.r_u) * glm::length(point.r_v))) return glm::length(off);
  return std::fabs(glm::dot(off, cross)) / length;
}

TEST(AdaptiveMesh, IsWithinItsToleranceAtPlacesThatNobodyLookedAt) {
  for (const Case& c : cases()) {
    for (const double share : {1e-2, 1e-3, 1e-4}) {
      const Surface surface = surface_of(c);
      const MeshResult result = mesh_of(c, share);
      const Locator locator(result.mesh);
      std::vector<dvec2> uv;
      for (std::uint64_t k = 0; k < 4000; ++k) {
        const dvec2 part(random_unit(1000000 + 2 * k), random_unit(1000001 + 2 * k));
        uv.push_back(dvec2(c.domain.u0, c.domain.v0) * (1.0 - part) +
                     dvec2(c.domain.u1, c.domain.v1) * part);
      }
      const std::vector<SurfacePoint> points = evaluate(surface, uv);
      double worst = 0;
      for (std::size_t k = 0; k < uv.size(); ++k) {
        worst = std::max(worst, distance(locator, points[k], uv[k]));
      }
      const double eps = *result.report.tolerance;
      EXPECT_LE(worst, eps) << c.name << ' ' << share;
      EXPECT_LE(result.report.max_error, eps) << c.name << ' ' << share;
      // Coarser meshes may be as fine as their grid lines.
      const double finest = share < 1e-3 ? 0.3 : 0;
      EXPECT_GE(worst, finest * eps) << c.name << ' ' << share << " is far finer than asked";
    }
  }
}

/// The distance of a position from a height field, by samples around it.
double distance_from_field(const dvec3& position, double (*z)(double u, double v), dvec2 reach) {
  constexpr int kStepsU = 60;  // waves are steep along u
  constexpr int kStepsV = 4;
  dvec2 nearest(position);
  double least = std::fabs(position.z - z(nearest.x, nearest.y));
  for (int round = 0; round < 5; ++round, reach *= 0.2) {
    const dvec2 middle = nearest;
    for (int i = -kStepsU; i <= kStepsU; ++i) {
      for (int j = -kStepsV; j <= kStepsV; ++j) {
        const dvec2 at = middle + reach * dvec2(i, j) / dvec2(kStepsU, kStepsV);
        const double distance = glm::distance(position, dvec3(at, z(at.x, at.y)));
        if (distance < least) nearest = at;
        least = std::min(least, distance);
      }
    }
  }
  return least;
}

TEST(AdaptiveMesh, IsNearTheSurfaceInWavesNarrowerThanTheyAreHigh) {
  const Domain domain = {-1, 1, -20, 20};
  const MeshResult twisted =
      try_mesh(height_field("sin(30*u)*cos(v)", domain), within_share(1e-3)).value();
  const MeshResult valley =
      try_mesh(height_field("sin(50*u)+v^2/100", domain), within_share(1e-3)).value();
  const auto worst = [](const MeshResult& result, double (*z)(double u, double v)) {
    const double most = 1.02 * *result.report.tolerance;
    double worst = 0;
    for (const Triangle& t : result.mesh.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const dvec3& a = result.mesh.position[t[k]];
        const dvec3& b = result.mesh.position[t[(k + 1) % 3]];
        const dvec3 middle = 0.5 * (a + b);
        // Most are that near straight above.
        if (std::fabs(middle.z - z(middle.x, middle.y)) <= most) continue;
        worst = std::max(worst, distance_from_field(middle, z, {0.04, 0.1}));
      }
    }
    return worst / most;
  };
  EXPECT_LE(worst(twisted, [](double u, double v) { return std::sin(30 * u) * std::cos(v); }), 1);
  EXPECT_LE(worst(valley, [](double u, double v) { return std::sin(50 * u) + v * v / 100; }), 1);
}

MeshRequest without_lines(double share) {
  MeshRequest options = within_share(share, 180);
  options.lines = {0, 0};
  return options;
}

TEST(AdaptiveMesh, IsAsCoarseAsASaddleAllows) {
  // Where a surface bends to both sides its errors along u and along v do not add up.
  const Case catenoid = {
      "catenoid", "cosh(v)*cos(u)", "cosh(v)*sin(u)", "v", {0, 2 * kPi, -1.2, 1.2}};
  const MeshResult result = try_mesh(surface_of(catenoid), without_lines(1e-3)).value();
  EXPECT_LT(static_cast<double>(result.mesh.triangles.size()), 1.9 * result.report.least_triangles);
}

TEST(AdaptiveMesh, IsHalvedNoFurtherThanAPeakNeeds) {
  const Case maximum = {"peak", "u", "v", "exp(-40*((u-0.3)^2+(v+0.2)^2))", {-1, 1, -1, 1}};
  const MeshResult result = try_mesh(surface_of(maximum), without_lines(1e-2)).value();
  EXPECT_GT(result.mesh.bounds.high.z, 0.95);
  EXPECT_LT(result.mesh.triangles.size(), 250U);
}

TEST(AdaptiveMesh, KeepsTheToleranceOfNormals) {
  for (const Case& c : cases()) {
    const MeshResult loose = mesh_of(c, 1e-3);
    const MeshResult strict = mesh_of(c, 1e-3, 0.5);
    EXPECT_LE(strict.report.max_normal_error, 0.5) << c.name;
    if (loose.report.max_normal_error <= 0.5) continue;  // as the sphere's, whatever its mesh
    EXPECT_GT(strict.mesh.triangles.size(), loose.mesh.triangles.size()) << c.name;
  }
}

TEST(AdaptiveMesh, HasNoCracks) {
  // Open edges are those of the domain, as long as the domain's border is.
  const std::map<std::string, long> euler = {
      {"sphere", 2},   {"torus", 0},   {"catenoid", 0}, {"figure-8", 0}, {"mobius", 0},
      {"helicoid", 1}, {"enneper", 1}, {"monkey", 1},   {"peak", 1},     {"ripple", 1}};
  for (const Case& c : cases()) {
    for (const double share : {1e-2, 1e-3}) {
      const MeshResult result = mesh_of(c, share);
      const Mesh& mesh = result.mesh;
      EXPECT_EQ(euler_number(mesh), euler.at(c.name)) << c.name << ' ' << share;
      for (const auto& [edge, count] : edge_counts(mesh)) ASSERT_LE(count, 2) << c.name;
      EXPECT_EQ(triangles_against_normals(mesh), 0U) << c.name << ' ' << share;
    }
  }
}

TEST(AdaptiveMesh, IsClosedWhereTheSurfaceIs) {
  for (const Case& c : cases()) {
    const std::string name = c.name;
    if (name != "sphere" && name != "torus" && name != "figure-8") continue;
    const MeshResult result = mesh_of(c, 1e-3);
    for (const auto& [edge, count] : edge_counts(result.mesh)) ASSERT_EQ(count, 2) << c.name;
  }
}

TEST(AdaptiveMesh, CoversTheWholeDomainOnce) {
  for (const Case& c : cases()) {
    const Mesh mesh = mesh_of(c, 1e-3).mesh;
    double sum = 0;
    for (const Triangle& t : mesh.triangles) {
      const dvec2 a = mesh.uv[t[1]] - mesh.uv[t[0]];
      const dvec2 b = mesh.uv[t[2]] - mesh.uv[t[0]];
      const double area = (a.x * b.y - a.y * b.x) / 2;
      ASSERT_GT(area, 0) << c.name;
      sum += area;
    }
    const Domain& d = c.domain;
    const double whole = (d.u1 - d.u0) * (d.v1 - d.v0);
    // At the sphere's poles one triangle of each cell is a point in space, and left out.
    const bool has_poles = std::string(c.name) == "sphere";
    EXPECT_NEAR(sum, whole, has_poles ? 0.1 * whole : 1e-9 * whole) << c.name;
  }
}

TEST(AdaptiveMesh, HasTheGridLinesAmongItsEdges) {
  for (const Case& c : cases()) {
    const Mesh mesh = mesh_of(c, 1e-3).mesh;
    const std::map<PointEdge, int> edges = edge_counts(mesh);
    EXPECT_GE(mesh.lines.size(), 30U) << c.name;
    for (const auto& line : mesh.lines) {
      for (std::size_t k = 1; k < line.size(); ++k) {
        const auto [a, b] = std::pair(line[k - 1], line[k]);
        ASSERT_TRUE(edges.contains(point_edge(mesh, a, b))) << c.name;
      }
    }
  }
}

TEST(AdaptiveMesh, DoesNotRefineTheWholeDomainForANarrowPeak) {
  const Case narrow = {"narrow", "u", "v", "exp(-400*((u-0.123)^2+(v+0.321)^2))", {-1, 1, -1, 1}};
  const MeshResult result = mesh_of(narrow, 1e-3);
  EXPECT_NEAR(result.mesh.bounds.high.z, 1, 0.02);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_LT(result.mesh.triangles.size(), 3000U);
}

TEST(AdaptiveMesh, MakesTwoTrianglesOfAPlane) {
  MeshRequest options = within_share(1e-3, 3);
  options.lines = {0, 0};
  const Surface plane = surface_from_text("u+v", "v", "2*u-3*v", {}, {}, Order::Second);
  EXPECT_EQ(try_mesh(plane, options)->mesh.triangles.size(), 2U);
}

TEST(AdaptiveMesh, FollowsTheEdgeOfTheDomainWhateverTheSurfaceDoesInside) {
  // A flat disc: all of its curvature is in its edge.
  const Case disc = {"disc", "v*cos(u)", "v*sin(u)", "0", {0, 2 * kPi, 0.5, 1}};
  const MeshResult result = mesh_of(disc, 1e-4);
  double area_of_mesh = area(result.mesh);
  // An arc off by eps from a chord of length l hides 2/3 eps l, all around both circles.
  EXPECT_NEAR(area_of_mesh, 0.75 * kPi, *result.report.tolerance * 2 * kPi * 1.5);
}

/// Searches, validation and proofs share out sides, leaves and boxes.
TEST(AdaptiveMesh, IsTheSameForAnyNumberOfThreads) {
  std::vector<Surface> surfaces = {surface_of(cases().back())};
  for (const char* z : {"sqrt(0.5-u*u-v*v)+floor(3*u+v)/4", "abs(sin(9*u)*sin(9*v))", "1/(u-v*v)",
                        "tanh(300*(u-v))+exp(-900*(u*u+v*v))"})
    surfaces.push_back(height_field(z));
  // Singular points on both sides of a crease.
  surfaces.push_back(
      surface_from_text("1/sin(u)", "gamma(3*u)", "u+sin(3*v)", {0, 2, -1, 3}, {}, Order::Second));
  for (const Surface& surface : surfaces) {
    MeshRequest options = within_share(1e-3, 3);
    options.clip = Bounds{{-2, -2, -2}, {2, 2, 2}};
    options.threads = 1;
    const MeshResult one = try_mesh(surface, options).value();
    options.threads = 3;
    const MeshResult three = try_mesh(surface, options).value();
    EXPECT_EQ(one.mesh.position, three.mesh.position);
    EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
    EXPECT_EQ(one.report.max_error, three.report.max_error);
    EXPECT_EQ(one.report.evaluations, three.report.evaluations);
    EXPECT_EQ(one.report.proved_fraction, three.report.proved_fraction);
    EXPECT_GT(three.mesh.triangles.size(), 500U);  // enough to share
  }
}

MeshResult with_few_samples_in_memory(const Surface& surface, MeshRequest request) {
  request.leaves_at_a_time = 20;
  return try_mesh(surface, request).value();
}

/// Leaves that are estimated later know the halvings of others: a side that is halved is no edge.
TEST(AdaptiveMesh, IsAsGoodHoweverFewSamplesAreInMemory) {
  for (const Case& c : cases()) {
    const MeshResult known = mesh_of(c, 1e-3);
    const MeshResult forgotten = with_few_samples_in_memory(surface_of(c), within_share(1e-3));
    EXPECT_LE(forgotten.report.max_error, *forgotten.report.tolerance) << c.name;
    EXPECT_EQ(euler_number(forgotten.mesh), euler_number(known.mesh)) << c.name;
    for (const auto& [edge, count] : edge_counts(forgotten.mesh)) ASSERT_LE(count, 2) << c.name;
    const auto cells = static_cast<double>(known.report.cells);
    EXPECT_NEAR(static_cast<double>(forgotten.report.cells), cells, 0.05 * cells) << c.name;
  }
}

TEST(AdaptiveMesh, FollowsFeaturesHoweverManySamplesAreInMemory) {
  for (const char* z :
       {"floor(3*sin(u*v))", "sqrt(1-u^2-v^2)", "1/(u-v)", "abs(sin(3*u)*v)", "(u^2+v^2<0.003)?1:0",
        "tanh(1e4*(u^2+v^2-0.5))", "u*v/(u^2+v^2)", "sqrt(u)+sqrt(v)", "min(u,v)^(1/3)"}) {
    const Surface surface = height_field(z, {-1.1, 1, -1.05, 1});
    const MeshRequest request = within_share(1e-3);
    const MeshReport forgotten = with_few_samples_in_memory(surface, request).report;
    const MeshReport known = try_mesh(surface, request)->report;
    EXPECT_LT(forgotten.max_error, 1.02 * std::max(known.max_error, *known.tolerance)) << z;
    EXPECT_EQ(forgotten.pole_count > 0, known.pole_count > 0) << z;
    EXPECT_EQ(forgotten.jump_count > 0, known.jump_count > 0) << z;
    EXPECT_NEAR(forgotten.undefined_fraction, known.undefined_fraction, 1e-3) << z;
    EXPECT_NEAR(static_cast<double>(forgotten.cells), static_cast<double>(known.cells),
                0.02 * static_cast<double>(known.cells))
        << z;
  }
}

TEST(AdaptiveMesh, LeavesToTheUniformGridWhatIsDefinedNowhere) {
  const Surface nowhere = height_field("sqrt(-1-u^2)");
  EXPECT_FALSE(try_mesh(nowhere, within_share(1e-3)).has_value());
}

TEST(AdaptiveMesh, NeedsFewTrianglesBesideTheLeastPossible) {
  double product = 1;
  int count = 0;
  for (const Case& c : cases()) {
    const MeshResult result = mesh_of(c, 1e-4);
    const double efficiency =
        static_cast<double>(result.mesh.triangles.size()) / result.report.least_triangles;
    EXPECT_LT(efficiency, 7) << c.name;  // waves across the grid's directions are the dearest
    product *= efficiency;
    ++count;
  }
  EXPECT_LT(std::pow(product, 1.0 / count), 3.5);
}

}  // namespace
}  // namespace saddle
