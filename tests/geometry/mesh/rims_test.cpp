// Where a surface ends inside of the domain: at its rim the mesh ends too, within the tolerance,
// however the rim lies to the lines of the mesh; and no part of it is too small to be found.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult mesh_of_rim(const char* z, double tolerance, int lines = 0) {
  MeshRequest options = within_share(tolerance);
  options.lines = {lines, lines};
  const Surface surface = height_field(z);
  return try_mesh(surface, options).value();
}

/// The largest distance of a point of the unit hemisphere from a mesh.
double off_hemisphere(const Mesh& mesh) {
  const TriangleTree tree(mesh);
  double worst = 0;
  constexpr int kAround = 2000;
  for (int i = 0; i < kAround; ++i) {
    const double a = 2 * std::numbers::pi * i / kAround;
    for (const double height : {0.0, 0.003, 0.01, 0.02, 0.03, 0.05, 0.1}) {
      const double across = std::sqrt(1 - height * height);
      worst = std::max(worst, tree.distance({across * std::cos(a), across * std::sin(a), height}));
    }
  }
  return worst;
}

TEST(Rims, AreRightWhereTheyTouchTheEdgeOfTheDomain) {
  for (const int lines : {0, 7, 16}) {
    const MeshResult result = mesh_of_rim("sqrt(1-u^2-v^2)", 5e-4, lines);
    EXPECT_LE(off_hemisphere(result.mesh), *result.report.tolerance) << lines;
    EXPECT_EQ(euler_number(result.mesh), 1) << lines;
  }
}

TEST(Rims, AreMeshedToTheTipsOfCusps) {
  for (const double a : {0.0, 0.013, -0.021, 0.34}) {
    const std::string from = std::to_string(a);
    const MeshResult result =
        mesh_of_rim(("((u-" + from + ")^3-(v-" + from + ")^2)^(2/3)").c_str(), 1e-3, 16);
    const TriangleTree tree(result.mesh);
    double worst = 0;
    for (double t = -0.5; t <= 0.5; t += 1e-3)
      worst = std::max(worst, tree.distance({a + t * t, a + t * t * t, 0}));
    EXPECT_LE(worst, 1.02 * *result.report.tolerance) << a;
  }
}

TEST(Rims, AreFoundWhereNothingBesideAHoleTellsOfIt) {
  // As flat as a sheet; the hole, of a radius of 0.02, lies between all samples.
  const MeshResult result = mesh_of_rim("1e-9*sqrt((u-0.03)^2+(v-0.04)^2-0.0004)", 1e-3, 16);
  EXPECT_EQ(euler_number(result.mesh), 0);
  const dvec2 centre(0.03, 0.04);
  double nearest = 1;
  for (const Triangle& t : result.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec2 middle = 0.5 * (result.mesh.uv[t[k]] + result.mesh.uv[t[(k + 1) % 3]]);
      nearest = std::min(nearest, glm::distance(middle, centre));
    }
  }
  EXPECT_GE(nearest, 0.02 - *result.report.tolerance);
}

TEST(Rims, KeepTheToleranceOnEitherSideOfTheirChords) {
  // The rim bends away from the surface, which stands upright on it.
  const MeshResult result = mesh_of_rim("sqrt(u^2+v^2-0.3)", 1e-3);
  const TriangleTree tree(result.mesh);
  double from_surface = 0;
  double from_rim = 0;
  for (int i = 0; i < 2000; ++i) {
    const double a = 2 * std::numbers::pi * i / 2000;
    for (const double height : {0.0, 0.01, 0.02, 0.04, 0.08, 0.16}) {
      const double across = std::sqrt(0.3 + height * height);
      from_surface = std::max(from_surface,
                              tree.distance({across * std::cos(a), across * std::sin(a), height}));
    }
  }
  for (const Triangle& t : result.mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 middle =
          0.5 * (result.mesh.position[t[k]] + result.mesh.position[t[(k + 1) % 3]]);
      from_rim = std::max(from_rim, std::sqrt(0.3) - std::hypot(middle.x, middle.y));
    }
  }
  EXPECT_LE(from_surface, *result.report.tolerance);
  EXPECT_LE(from_rim, *result.report.tolerance);
}

TEST(Rims, OfNarrowStripsDoNotTearThem) {
  const MeshResult result = mesh_of_rim("sqrt(1e-4-(u-v)^2)", 1e-3, 16);
  const TriangleTree tree(result.mesh);
  for (int k = 0; k <= 1000; ++k) {
    const double u = -1 + 0.002 * k;
    EXPECT_LE(tree.distance({u, u, 0.01}), *result.report.tolerance) << u;
  }
}

TEST(Islands, ThatNoCellOfTheRootGridHoldsAreFound) {
  struct Case {
    const char* z;
    double area_in_uv;
  };
  for (const auto& [z, expected] :
       {Case{"sqrt(u-0.999)", 0.002}, Case{"sqrt(1e-6-(u-0.3)^2)", 0.004},
        Case{"sqrt(1e-7-(u-0.3)^2-(v+0.2)^2)", std::numbers::pi * 1e-7}}) {
    const MeshResult result = mesh_of_rim(z, 1e-3, 16);
    double sum = 0;
    for (const Triangle& t : result.mesh.triangles) {
      const dvec2 a = result.mesh.uv[t[1]] - result.mesh.uv[t[0]];
      const dvec2 b = result.mesh.uv[t[2]] - result.mesh.uv[t[0]];
      sum += 0.5 * std::fabs(a.x * b.y - a.y * b.x);
    }
    EXPECT_NEAR(sum, expected, 0.01 * expected) << z;
    EXPECT_NEAR(1 - sum / 4, result.report.undefined_fraction, 1e-9) << z;
  }
}

TEST(Islands, BesideWhatIsFoundAnywayAreFound) {
  // Two discs of which one has a radius of 0.01, far less than a cell of the root grid.
  const MeshResult result =
      mesh_of_rim("sqrt(max(0.25-(u+0.4)^2-v^2,1e-4-(u-0.723)^2-(v-0.517)^2))", 1e-3, 16);
  const TriangleTree tree(result.mesh);
  EXPECT_LE(tree.distance({0.723, 0.517, 0.01}), *result.report.tolerance);
}

TEST(Rims, AreCirclesAroundAHemisphere) {
  const MeshResult result =
      try_mesh(height_field("sqrt(1-u^2-v^2)", {-1.5, 1.5, -1.5, 1.5}), within_share(1e-3, 3))
          .value();
  const Mesh& mesh = result.mesh;
  const double eps = *result.report.tolerance;
  EXPECT_LE(result.report.max_error, eps);
  EXPECT_NEAR(result.report.undefined_fraction, 1 - kPi / 9, 1e-3);
  EXPECT_NEAR(area(mesh), 2 * kPi, 2 * kPi * eps * 2);
  int on_boundary = 0;
  for (const auto& [edge, count] : edge_counts(mesh)) {
    ASSERT_LE(count, 2);
    if (count == 2) continue;
    ++on_boundary;  // every open edge is a chord of the unit circle
    for (std::size_t k = 0; k < mesh.point.size(); ++k) {
      if (mesh.point[k] != edge.first && mesh.point[k] != edge.second) continue;
      EXPECT_NEAR(std::hypot(mesh.position[k].x, mesh.position[k].y), 1, 1e-12);
      EXPECT_NEAR(mesh.position[k].z, 0, 1e-6);
      EXPECT_NEAR(mesh.normal[k].z, 0, 1e-3);  // upright, as the sphere is there
    }
  }
  EXPECT_GT(on_boundary, 20);
  EXPECT_EQ(euler_number(mesh), 1);
  EXPECT_EQ(triangles_against_normals(mesh), 0U);
}

/// A slanting boundary cannot have long cells along it. A sphere takes 33,000 triangles in all.
TEST(Rims, LeaveTheMeshBesideThemAsCoarseAsItMayBe) {
  const MeshResult result = mesh_of_rim("sqrt(1-u^2-v^2)", 1e-4);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_LT(result.mesh.triangles.size(), 45'000U);
  EXPECT_LT(result.report.evaluations, 4'000'000U);
}

/// Beside the rim of a tenth root doubles end at a height of 0.025. The mesh goes on to 0, and so
/// does the exact surface, which is at radius sqrt(1 - z^10).
TEST(Rims, OfHighRootsKeepTheTolerance) {
  const MeshResult result = mesh_of_rim("(1-u^2-v^2)^0.1", 1e-3);
  const double tolerance = *result.report.tolerance;
  EXPECT_LE(result.report.max_error, tolerance);
  EXPECT_LT(result.report.cells, 15'000U);
  const Mesh& mesh = result.mesh;
  double worst = 0;
  for (const Triangle& t : mesh.triangles) {
    const dvec3 p =
        (mesh.position[t[0]] + mesh.position[t[1]] + mesh.position[t[2]]) / 3.0;  // its middle
    const double r = std::hypot(p.x, p.y);
    const double across = std::fabs(r - std::sqrt(1 - std::pow(p.z, 10)));
    const double along = std::fabs(p.z - std::pow(std::max(1 - r * r, 0.0), 0.1));
    worst = std::max(worst, std::min(across, along));
  }
  EXPECT_LT(worst, 1.2 * tolerance);
}

TEST(Rims, AreWhereLinesEnd) {
  const Mesh mesh = try_mesh(height_field("sqrt(1-u^2-v^2)"), within_share(1e-3)).value().mesh;
  const std::map<PointEdge, int> edges = edge_counts(mesh);
  for (const auto& line : mesh.lines) {
    for (const std::uint32_t end : {line.front(), line.back()}) {
      const dvec3& p = mesh.position[end];
      EXPECT_NEAR(std::hypot(p.x, p.y), 1, 1e-12);
    }
    for (std::size_t k = 1; k < line.size(); ++k) {
      ASSERT_TRUE(edges.contains(point_edge(mesh, line[k - 1], line[k])));
    }
  }
}

/// A corner of upright tangents: a millionth of a cell away the surface is higher by a tolerance.
/// The rim of a hemisphere in polar coordinates runs along v = 1: halves beside it become slivers,
/// but its chords no shorter, if these are not halved as well.
TEST(Rims, AlongALineOfConstantVAreHalved) {
  const Surface polar = surface_from_text("cos(u)*v", "sin(u)*v", "sqrt(1-v^2)",
                                          {0, 2 * std::numbers::pi, 0, 1.3}, {}, Order::Second);
  for (const double share : {3e-3, 1e-3, 3e-4}) {
    const MeshResult mesh = try_mesh(polar, within_share(share)).value();
    EXPECT_LE(mesh.report.max_error, mesh.report.tolerance) << share;
    EXPECT_LE(off_hemisphere(mesh.mesh), *mesh.report.tolerance) << share;
    EXPECT_LT(static_cast<double>(mesh.mesh.triangles.size()), 5 * mesh.report.least_triangles)
        << share;
  }
}

TEST(Rims, ThatCrossEndInACorner) {
  for (const char* z : {"sqrt(4-u^2)+sqrt(4-v^2)", "asin(u/2)+acos(v/2)"}) {
    const Surface surface = height_field(z, {-3, 3, -3, 3});
    const MeshResult result = try_mesh(surface, within_length(4e-3)).value();
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
  }
}

/// Of a cell on the other side of such a line no more is defined than the side that they share.
TEST(Rims, OnLinesOfTheMeshTakeNoTrianglesBeyondThem) {
  const auto mesh_over = [](double u0) {
    return try_mesh(height_field("sqrt(u)", {u0, 2, -1, 1}), within_length(2e-3)).value();
  };
  const MeshResult half = mesh_over(0);
  const MeshResult whole = mesh_over(-1);
  EXPECT_EQ(whole.report.flat_triangles, 0U);
  EXPECT_TRUE(std::ranges::all_of(whole.report.singular_points, &SingularPoint::has_limit));
  EXPECT_EQ(whole.report.singular_point_count, half.report.singular_point_count);
  EXPECT_EQ(whole.mesh.bounds.low.x, 0);
  EXPECT_LT(whole.mesh.triangles.size(), 1.2 * static_cast<double>(half.mesh.triangles.size()));
}

/// Second derivatives are endless beside the rim, which is no reason for lines across the surface.
TEST(Rims, ThatComeNearALineOfSamplesDrawNoDenseLines) {
  const Surface surface = height_field("sqrt(9-u^2-v^2)", {-5, 5, -5, 5});
  const MeshResult result = try_mesh(surface, within_length(4.4e-3)).value();
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_FALSE(result.report.oscillates);
  EXPECT_LT(result.mesh.triangles.size(), 10'000U);
}

TEST(Rims, HaveUnitNormalsWhereTheFormulaBesideThemHasDerivatives) {
  // Beyond the rim the least of 0.3 and an undefined number is undefined, with derivatives of 0.
  const MeshResult result = mesh_of_rim("min(0.3, sqrt(1-u^2-v^2))", 1e-3);
  for (const dvec3& normal : result.mesh.normal) EXPECT_NEAR(glm::length(normal), 1, 1e-9);
}

TEST(Rims, OfTheDomainKeepTheToleranceWhereACuspEnds) {
  const MeshResult result = mesh_of_rim("sqrt(abs(u+v))", 1e-3);
  const TriangleTree tree(result.mesh);
  for (double d = 1e-4; d < 0.05; d *= 1.1)
    EXPECT_LE(tree.distance({1, d - 1, std::sqrt(d)}), *result.report.tolerance) << d;
}

TEST(Rims, KeepTheToleranceWhereAJumpMeetsThem) {
  const MeshResult result =
      try_mesh(height_field("sqrt(1-u^2-v^2)*sign(u-v)"), within_length(1.4e-3)).value();
  EXPECT_LE(result.report.max_error, 1.4e-3);
}

/// The rim turns by 8 degrees where the two roots are 0, and the surface goes down to 0 there
/// alone.
TEST(Rims, GoDownToTheNotchWhereTwoMeet) {
  const MeshResult result = mesh_of_rim("sqrt(u-1.303*v+0.006644)+sqrt(u-v)", 1e-3);
  const double at = 0.006644 / 0.303;
  EXPECT_LE(TriangleTree(result.mesh).distance({at, at, 0}), *result.report.tolerance);
}

/// Two jumps end on the rim in (0, 0), where the sheet between them goes down to 0. Other jumps
/// touch the rim: the wedges beside them are halved from leaf to leaf.
TEST(Rims, HaveTheirCornersWhereAClipBoxCutsElsewhere) {
  constexpr double kTolerance = 0.0066;
  MeshRequest request = within_length(kTolerance);
  request.clip = Bounds{dvec3(-1, -1, -3), dvec3(1, 1, 3)};
  const Surface square = height_field("(abs(u)<0.5&&abs(v)<0.5)?1/(u+v):nan");
  const Mesh mesh = try_mesh(square, request).value().mesh;
  EXPECT_LE(TriangleTree(mesh).distance({-0.5, -0.5, -1}), kTolerance);
}

TEST(Rims, KeepTheToleranceInAPointBetweenAJumpAndARim) {
  const Surface surface =
      height_field("max(sqrt(tanh(u+v)),atan(mod(u*v,1)))", {-1.9, 1.9, -1.9, 1.9});
  const MeshResult result = try_mesh(surface, within_share(1e-3)).value();
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  const TriangleTree tree(result.mesh);
  for (double u = 1e-9; u < 0.1; u *= 3)
    EXPECT_LE(tree.distance({u, u, std::sqrt(std::tanh(2 * u))}), *result.report.tolerance) << u;
}

/// On the rim sign() is 0: a value of its own there is no part of the surface.
TEST(Rims, ThatCrossLeaveTheSheetsBetweenThemApart) {
  struct Sheets {
    const char* z;
    double highest;  ///< of a triangle on one of them
  };
  for (const auto& [z, highest] :
       {Sheets{"((u-.13)*(v-.17)>0)?sign(u-.13):nan", 0},
        {"(mod(floor(3*u-.1)+floor(3*v-.2),2)==0)?floor(3*u-.1)/3:nan", 0},
        {"(u*v>0)?atan2(v,u):nan", std::numbers::pi / 2},
        {"(abs(v)<abs(u))?atan2(v,u):nan", std::numbers::pi / 2}}) {
    const Mesh mesh = mesh_of_rim(z, 1e-3).mesh;
    ASSERT_FALSE(mesh.triangles.empty()) << z;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto [low, high] =
          std::minmax({mesh.position[a].z, mesh.position[b].z, mesh.position[c].z});
      ASSERT_LE(high - low, highest + 1e-9) << z;
    }
  }
}

TEST(Rims, LeaveOutValuesOfTheirOwn) {
  const Surface surface = height_field("sign(u*sqrt(u+v))", {-2, 2, -2, 2});
  const MeshResult result = try_mesh(surface, within_share(1e-3)).value();
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  const TriangleTree tree(result.mesh);
  EXPECT_LE(tree.distance({-1e-4, 1.1e-4, -1}), *result.report.tolerance);
  // On the line u = 0, where the jump is, the value is one of each side's.
  std::size_t between = 0;
  for (const dvec3& p : result.mesh.position) {
    if (std::fabs(p.z) < 0.5 && p.x != 0) ++between;
  }
  EXPECT_EQ(between, 0U);
}

/// On v = 0 the height is (1 - u^0.25)^0.25, up to u = 1. The surface is (1 - u^0.25)^4 wide there:
/// 1e-7 at u = 0.93, far less than a cell.
TEST(Rims, OfTipsThinnerThanACellAreToldAtTheirFullLength) {
  for (const int lines : {0, 16}) {
    const MeshResult result = mesh_of_rim("(1-u^0.25-v^0.25)^0.25", 1e-3, lines);
    const TriangleTree tree(result.mesh);
    double worst = 0;
    constexpr int kPlaces = 1000;
    for (int k = 0; k <= kPlaces; ++k) {
      const double u = static_cast<double>(k) / kPlaces;
      const double height = std::pow(1 - std::pow(u, 0.25), 0.25);
      worst = std::max({worst, tree.distance({u, 0, height}), tree.distance({0, u, height})});
    }
    EXPECT_GE(1.1 * std::max(result.report.max_error, *result.report.tolerance), worst) << lines;
    EXPECT_LE(result.report.max_error, std::max(3 * worst, *result.report.tolerance)) << lines;
  }
}

}  // namespace
}  // namespace saddle
