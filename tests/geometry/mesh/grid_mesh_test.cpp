#include "mesh/mesher/grid_mesh.h"
#include "mesh/model/mesh_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "mesh_checks.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

// Sums of some ten thousand terms, each right to some ULPs.
constexpr double kSumRounding = 1e-12;
constexpr double kLimitError = 1e-11;  // see normal_test.cpp

GridOptions cells(int u, int v) {
  GridOptions options;
  options.cells_u = u;
  options.cells_v = v;
  return options;
}

Surface sphere(const Domain& domain = {0, 2 * kPi, 0, kPi}) {
  return surface_from_text("cos(u)*sin(v)", "sin(u)*sin(v)", "cos(v)", domain);
}

Surface torus(const Domain& domain = {0, 2 * kPi, 0, 2 * kPi}) {
  return surface_from_text("(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)", "sin(v)", domain);
}

Surface hemisphere() {
  return surface_from_text("u", "v", "sqrt(1-u^2-v^2)", {});
}

Surface double_cone() {
  return surface_from_text("v*cos(u)", "v*sin(u)", "v", {0, 2 * kPi, -1, 1});
}

bool is_finite(const dvec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

/// What every mesh must be, whatever the surface.
void expect_sound(const Mesh& mesh) {
  const std::size_t corners = mesh.position.size();
  ASSERT_EQ(mesh.normal.size(), corners);
  ASSERT_EQ(mesh.uv.size(), corners);
  ASSERT_EQ(mesh.point.size(), corners);
  std::vector<bool> used(corners);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      ASSERT_LT(corner, corners);
      used[corner] = true;
    }
  }
  std::vector<const dvec3*> place(mesh.point_count);
  for (std::size_t k = 0; k < corners; ++k) {
    EXPECT_TRUE(used[k]) << k;
    EXPECT_TRUE(is_finite(mesh.position[k])) << k;
    EXPECT_NEAR(glm::length(mesh.normal[k]), 1, 1e-14) << k;
    ASSERT_LT(mesh.point[k], mesh.point_count);
    const dvec3*& first = place[mesh.point[k]];
    if (!first) first = &mesh.position[k];
    EXPECT_EQ(std::memcmp(first, &mesh.position[k], sizeof(dvec3)), 0) << k;
  }
  for (const dvec3* p : place) EXPECT_NE(p, nullptr);
}

TEST(MeshResult, OfASphereIsClosedAndSound) {
  const MeshResult result = mesh_on_grid(sphere(), cells(24, 12));
  expect_sound(result.mesh);
  EXPECT_EQ(euler_number(result.mesh), 2);
  EXPECT_EQ(result.mesh.triangles.size(), 2U * 24 * 12 - 2 * 24);  // one per cell at the poles
  EXPECT_EQ(result.mesh.point_count, 24U * 11 + 2);
  EXPECT_EQ(result.report.cells, 24U * 12);
}

// The mesh is the convex hull of points on the unit sphere. Each of its points is in a triangle
// whose corners are within `reach` of a cell's middle, so it is at least cos(reach) from the
// centre.
TEST(MeshResult, OfASphereHasItsAreaAndVolume) {
  const Mesh mesh = mesh_on_grid(sphere(), cells(60, 30)).mesh;
  const double reach = std::hypot(kPi / 60, kPi / 60);
  const double inner = std::cos(reach);
  EXPECT_LT(area(mesh), 4 * kPi);
  EXPECT_GT(area(mesh), 4 * kPi * inner * inner);
  // r_u x r_v points inwards: the front is inside.
  EXPECT_LT(-volume(mesh), 4 * kPi / 3);
  EXPECT_GT(-volume(mesh), 4 * kPi / 3 * inner * inner * inner);
}

// The cells of a torus are plane trapezoids. Between two half-planes through the axis the solid
// has the volume sin(h) * integral of the radius over the cross section, a regular polygon.
TEST(MeshResult, OfATorusHasTheVolumeOfItsPolyhedron) {
  const Mesh mesh = mesh_on_grid(torus(), cells(48, 36)).mesh;
  const double polygon = 36 / 2.0 * std::sin(2 * kPi / 36);
  const double expected = 48 * std::sin(2 * kPi / 48) * 2 * polygon;
  EXPECT_NEAR(std::abs(volume(mesh)), expected, kSumRounding * expected);
}

TEST(MeshResult, OfATorusHasTheAreaOfItsPolyhedron) {
  const Mesh mesh = mesh_on_grid(torus(), cells(48, 36)).mesh;
  double expected = 0;
  for (int j = 0; j < 36; ++j) {
    const double side = 2 * std::sin(kPi / 48);
    const double bottom = side * (2 + std::cos(2 * kPi * j / 36));
    const double top = side * (2 + std::cos(2 * kPi * (j + 1) / 36));
    const double leg = 2 * std::sin(kPi / 36);
    const double height = std::sqrt(leg * leg - (top - bottom) * (top - bottom) / 4);
    expected += 48 * (top + bottom) / 2 * height;
  }
  EXPECT_NEAR(area(mesh), expected, kSumRounding * expected);
}

TEST(MeshResult, ConvergesToAreaAndVolumeOfTheTorus) {
  const Mesh mesh = mesh_on_grid(torus(), cells(200, 200)).mesh;
  // Both polyhedra are below the torus by sinc factors: 1 - h^2/6 per direction, twice at most.
  const double h = 2 * kPi / 200;
  EXPECT_NEAR(area(mesh), 8 * kPi * kPi, 8 * kPi * kPi * h * h / 3);
  EXPECT_NEAR(std::abs(volume(mesh)), 4 * kPi * kPi, 4 * kPi * kPi * h * h / 3);
}

TEST(MeshResult, HasExactNormalsEverywhereOnASphere) {
  const Mesh mesh = mesh_on_grid(sphere(), cells(20, 10)).mesh;
  for (std::size_t k = 0; k < mesh.normal.size(); ++k) {
    EXPECT_LT(glm::distance(mesh.normal[k], -glm::normalize(mesh.position[k])), kLimitError) << k;
  }
}

TEST(MeshResult, WindsTrianglesAsTheNormalsSay) {
  for (const Domain& domain : {Domain{0, 2 * kPi, 0, kPi}, Domain{2 * kPi, 0, 0, kPi},
                               Domain{0, 2 * kPi, kPi, 0}, Domain{2 * kPi, 0, kPi, 0}}) {
    for (const bool flip : {false, true}) {
      Surface surface = sphere(domain);
      surface.flip = flip;
      const Mesh mesh = mesh_on_grid(surface, cells(12, 7)).mesh;
      EXPECT_EQ(triangles_against_normals(mesh), 0U) << domain.u0 << ' ' << domain.v0;
      // The direction of the ranges does not matter, r_u x r_v does.
      EXPECT_EQ(volume(mesh) > 0, flip);
      EXPECT_EQ(euler_number(mesh), 2);
    }
  }
}

TEST(MeshResult, NeverOpposesItsNormalsOnSurfacesWithConesAndCusps) {
  const Surface pseudosphere =
      surface_from_text("cos(u)/cosh(v)", "sin(u)/cosh(v)", "v-tanh(v)", {0, 2 * kPi, -3, 3});
  for (const Surface& surface : {double_cone(), pseudosphere}) {
    const Mesh mesh = mesh_on_grid(surface, cells(40, 20)).mesh;
    expect_sound(mesh);
    EXPECT_EQ(triangles_against_normals(mesh), 0U);
  }
}

TEST(MeshResult, GivesADoubleConesApexOnePointAndTheNormalsOfItsRulings) {
  const MeshResult result = mesh_on_grid(double_cone(), cells(16, 4));
  std::set<std::uint32_t> apex;
  for (std::size_t k = 0; k < result.mesh.position.size(); ++k) {
    if (result.mesh.uv[k].y != 0) continue;
    apex.insert(result.mesh.point[k]);
    const double u = result.mesh.uv[k].x;
    const dvec3 ruling = std::sqrt(0.5) * dvec3(std::cos(u), std::sin(u), -1);
    const double off = std::min(glm::distance(result.mesh.normal[k], ruling),
                                glm::distance(result.mesh.normal[k], -ruling));
    EXPECT_LT(off, kLimitError);
  }
  EXPECT_EQ(apex.size(), 1U);
  EXPECT_EQ(result.report.singular_point_count, 17U);
  EXPECT_EQ(result.mesh.point_count, 4U * 16 + 1);
}

TEST(MeshResult, SplitsCornersAlongACuspEdge) {
  const Mesh mesh = mesh_on_grid(surface_from_text("u^2", "u^3", "v", {}), cells(10, 5)).mesh;
  int front = 0;
  int back = 0;
  for (std::size_t k = 0; k < mesh.uv.size(); ++k) {
    if (mesh.uv[k].x != 0) continue;
    front += glm::distance(mesh.normal[k], dvec3(0, -1, 0)) < kLimitError;
    back += glm::distance(mesh.normal[k], dvec3(0, 1, 0)) < kLimitError;
  }
  EXPECT_EQ(front, 6);
  EXPECT_EQ(back, 6);
  EXPECT_EQ(mesh.position.size(), 11U * 6 + 6);
  EXPECT_EQ(mesh.point_count, 11U * 6);
}

TEST(MeshResult, GivesAWhitneyUmbrellasPinchPointOneNormalPerCell) {
  const MeshResult result = mesh_on_grid(surface_from_text("u*v", "u", "v^2", {}), cells(4, 8));
  std::vector<dvec3> normals;
  for (std::size_t k = 0; k < result.mesh.uv.size(); ++k) {
    if (result.mesh.uv[k] == dvec2(0)) normals.push_back(result.mesh.normal[k]);
  }
  ASSERT_EQ(normals.size(), 4U);
  // r_u x r_v = (2v, -2v^2, -u), approached from cell centres (+-1/4, +-1/8).
  for (const dvec3& n : normals) {
    EXPECT_LT(glm::distance(glm::abs(n), std::sqrt(0.5) * dvec3(1, 0, 1)), kLimitError);
  }
  ASSERT_EQ(result.report.singular_points.size(), 1U);
  EXPECT_EQ(result.report.singular_points[0].uv, dvec2(0));
  EXPECT_TRUE(result.report.singular_points[0].has_limit);
}

TEST(MeshResult, UsesAndReportsTheFaceNormalWhereThereIsNoLimit) {
  const Surface surface = surface_from_text("u", "v", "u^0.95", {0, 1, 0, 1});
  const MeshResult result = mesh_on_grid(surface, cells(4, 3));
  expect_sound(result.mesh);
  ASSERT_EQ(result.report.singular_point_count, 4U);
  const double slope = std::pow(0.25, 0.95) / 0.25;  // of the chord over the first cell
  const dvec3 face = glm::normalize(dvec3(-slope, 0, 1));
  for (const SingularPoint& point : result.report.singular_points) {
    EXPECT_FALSE(point.has_limit);
    EXPECT_EQ(point.uv.x, 0);
  }
  for (std::size_t k = 0; k < result.mesh.uv.size(); ++k) {
    if (result.mesh.uv[k].x != 0) continue;
    EXPECT_LT(glm::distance(result.mesh.normal[k], face), 1e-14);
  }
}

TEST(MeshResult, ListsAtMostAThousandSingularPointsAndCountsAll) {
  const MeshResult result = mesh_on_grid(sphere(), cells(700, 2));
  EXPECT_EQ(result.report.singular_point_count, 2U * 701);
  EXPECT_EQ(result.report.singular_points.size(), 701U);  // every second
}

TEST(MeshResult, LeavesOutAndCountsUndefinedCells) {
  const int n = 20;
  const MeshResult result = mesh_on_grid(hemisphere(), cells(n, n));
  expect_sound(result.mesh);
  const auto defined = [&](int i, int j) {
    const double u = (2.0 * i - n) / n;
    const double v = (2.0 * j - n) / n;
    return 1 - u * u - v * v >= 0;
  };
  std::size_t kept = 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      kept += defined(i, j) && defined(i + 1, j) && defined(i, j + 1) && defined(i + 1, j + 1);
    }
  }
  EXPECT_EQ(result.report.cells, kept);
  EXPECT_EQ(result.mesh.triangles.size(), 2 * kept);
  EXPECT_DOUBLE_EQ(result.report.undefined_fraction,
                   1 - static_cast<double>(kept) / static_cast<double>(n * n));
}

TEST(MeshResult, DoesNotDependOnTheNumberOfThreads) {
  for (const Surface& surface : {torus(), sphere(), hemisphere()}) {
    GridOptions options = cells(120, 90);
    options.threads = 1;
    const MeshResult one = mesh_on_grid(surface, options);
    options.threads = 5;
    const MeshResult five = mesh_on_grid(surface, options);
    EXPECT_EQ(one.mesh.position, five.mesh.position);
    EXPECT_EQ(one.mesh.normal, five.mesh.normal);
    EXPECT_EQ(one.mesh.uv, five.mesh.uv);
    EXPECT_EQ(one.mesh.point, five.mesh.point);
    EXPECT_EQ(one.mesh.triangles, five.mesh.triangles);
    EXPECT_EQ(one.mesh.lines, five.mesh.lines);
    EXPECT_EQ(one.report.max_error, five.report.max_error);
    EXPECT_EQ(one.report.max_normal_error, five.report.max_normal_error);
    EXPECT_EQ(one.report.evaluations, five.report.evaluations);
  }
}

TEST(MeshResult, HasTheEndsOfTheRangesExactly) {
  const Mesh mesh = mesh_on_grid(torus({0.1, 0.7, 0.3, 1.1}), cells(7, 11)).mesh;
  EXPECT_EQ(mesh.uv.front(), dvec2(0.1, 0.3));
  EXPECT_EQ(mesh.uv.back(), dvec2(0.7, 1.1));
}

TEST(MeshResult, HitsZeroInTheMiddleOfASymmetricRange) {
  const Mesh mesh =
      mesh_on_grid(surface_from_text("u", "v", "u*v", {-kPi, kPi, -0.1, 0.1}), cells(14, 22)).mesh;
  EXPECT_EQ(std::count(mesh.uv.begin(), mesh.uv.end(), dvec2(0)), 1);
}

TEST(MeshResult, BoundsItself) {
  const Mesh mesh = mesh_on_grid(torus(), cells(8, 4)).mesh;
  EXPECT_NEAR(mesh.bounds.high.x, 3, 1e-15);
  EXPECT_NEAR(mesh.bounds.low.y, -3, 1e-15);
  EXPECT_NEAR(mesh.bounds.high.z, 1, 1e-15);
}

TEST(MeshResult, CutsCellsAlongTheDiagonalThatIsNearerToTheSurface) {
  // Either surface is a cylinder whose rulings are one family of diagonals. A cut along them leaves
  // the sagitta of the sides, h^2 / 4; along the others it would be h^2.
  const double h = 0.2;
  for (const char* z : {"(u+v)^2", "(u-v)^2"}) {
    const MeshResult result = mesh_on_grid(surface_from_text("u", "v", z, {}), cells(10, 10));
    EXPECT_LT(result.report.max_error, h * h / 4) << z;
  }
}

TEST(MeshResult, SharesACornerAmongNormalsLessThanADegreeApart) {
  // Approached from (+-a, +-b) the normals at the pinch point are along (+-2b, 0, +-a): two pairs,
  // 2 atan(a / 2b) apart.
  const Surface umbrella = surface_from_text("u*v", "u", "v^2", {});
  const auto corners_at_pinch = [&](int cells_u) {
    const Mesh mesh = mesh_on_grid(umbrella, cells(cells_u, 2)).mesh;
    return std::count(mesh.uv.begin(), mesh.uv.end(), dvec2(0));
  };
  EXPECT_EQ(corners_at_pinch(60), 4);   // 1.9 degrees
  EXPECT_EQ(corners_at_pinch(200), 2);  // 0.6 degrees
}

TEST(MeshResult, DoesNotDependOnSizeOrPlace) {
  const MeshResult plain = mesh_on_grid(torus(), cells(20, 10));
  for (const char* size : {"1e-200", "1e-8", "1e8", "1e150"}) {
    const Surface scaled = surface_from_text("s*(2+cos(v))*cos(u)", "s*(2+cos(v))*sin(u)",
                                             "s*sin(v)", {0, 2 * kPi, 0, 2 * kPi}, {{"s", size}});
    const MeshResult result = mesh_on_grid(scaled, cells(20, 10));
    EXPECT_EQ(result.mesh.triangles.size(), plain.mesh.triangles.size()) << size;
    EXPECT_EQ(euler_number(result.mesh), 0) << size;
    EXPECT_NEAR(result.report.max_error / std::stod(size), plain.report.max_error, 1e-12) << size;
  }
  const Surface away = surface_from_text("1e7+(2+cos(v))*cos(u)", "(2+cos(v))*sin(u)-1e7",
                                         "1e7+sin(v)", {0, 2 * kPi, 0, 2 * kPi});
  const MeshResult result = mesh_on_grid(away, cells(20, 10));
  EXPECT_EQ(euler_number(result.mesh), 0);
  EXPECT_EQ(triangles_against_normals(result.mesh), 0U);
}

TEST(MeshResult, CutsASampleNextToAPoleOffAsANeedle) {
  const Surface surface = surface_from_text("u", "v", "tan(u)", {0, kPi, 0, 1});
  const MeshResult result = mesh_on_grid(surface, cells(20, 5));  // tan(pi/2) is 1.6e16
  EXPECT_EQ(result.mesh.triangles.size(), 2U * 18 * 5);
  EXPECT_EQ(result.report.closed_u, "");
  EXPECT_LT(result.mesh.bounds.high.z, 10);
}

}  // namespace
}  // namespace saddle
