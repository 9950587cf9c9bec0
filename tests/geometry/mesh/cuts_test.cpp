// Where a surface jumps, is creased or has a cusp, the mesh is cut along it: both sides are there,
// each with its own normals, and nothing is between them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "mesh/features/discontinuities.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kTolerance = 1e-3;  // of the diagonal
constexpr double kThousandthDegree = 1e-3 * kPi / 180;

MeshResult mesh_of(const char* x, const char* y, const char* z, const Domain& domain) {
  const Surface surface = surface_from_text(x, y, z, domain, {}, Order::Second);
  return try_mesh(surface, within_share(kTolerance, 3)).value();
}

MeshResult mesh_of(const char* z) {
  return mesh_of("u", "v", z, {-1, 1, -1, 1});
}

dvec2 middle_in_uv(const Mesh& mesh, const Triangle& t) {
  return (mesh.uv[t[0]] + mesh.uv[t[1]] + mesh.uv[t[2]]) / 3.0;
}

/// The largest angle, in radians, between the normal of a corner and what `exact` says it is on the
/// side of the surface that the triangle is on.
template <class F>
double worst_normal(const Mesh& mesh, F exact) {
  double worst = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) {
      const dvec3 n = glm::normalize(exact(mesh.uv[corner], middle_in_uv(mesh, t)));
      worst = std::max(worst, std::acos(std::clamp(glm::dot(n, mesh.normal[corner]), -1.0, 1.0)));
    }
  }
  return worst;
}

TEST(Jumps, AreCutWithoutLosingAnything) {
  for (const char* z : {"floor(3*u)", "floor(2*u+v)", "sign(u-0.5)", "(u^2+v^2<0.5)?1:0"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_GT(result.report.jump_count, 0U) << z;
    EXPECT_NEAR(area_in_uv(result.mesh), 4, 1e-6) << z;
    for (const Triangle& t : result.mesh.triangles) {
      const double height = result.mesh.position[t[0]].z;
      ASSERT_EQ(result.mesh.position[t[1]].z, height) << z;
      ASSERT_EQ(result.mesh.position[t[2]].z, height) << z;
    }
  }
}

TEST(Jumps, DoNotShowTheValueAtTheVeryPlaceOfTheJump) {
  // Of u^2 + v^2 - 1 thousands of doubles beside each other are rounded to 0.
  for (const char* z : {"sign(u)", "sign(u-0.5)", "sign(u-v)", "sign(u^2+v^2-1)"}) {
    const MeshResult result = mesh_of(z);
    for (const Triangle& t : result.mesh.triangles) {
      for (const std::uint32_t corner : t) {
        ASSERT_EQ(std::fabs(result.mesh.position[corner].z), 1) << z;
      }
    }
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
  }
}

TEST(Jumps, ThroughVerticesTakeNoMoreTrianglesThanThoseBesideThem) {
  // Both halves are flat: what is halved is halved in vain.
  for (const auto& [on, beside] :
       {std::pair("sign(u-v)", "step(0,u-v)"), std::pair("sign(u^2-v^2)", "step(0,u^2-v^2)")}) {
    const MeshResult result = mesh_of(on);
    // A line through vertices takes a few more where it crosses another.
    EXPECT_LE(result.mesh.triangles.size(), 1.05 * mesh_of(beside).mesh.triangles.size()) << on;
    EXPECT_NEAR(area_in_uv(result.mesh), 4, 1e-6) << on;
  }
}

TEST(Jumps, ThatSamplesDoNotTellApartAreAllCut) {
  // Thirty sheets side by side, each as the next one: chords from one to another look like either.
  const Surface surface = surface_from_text("floor(v)*0.01", "u", "2*(v-floor(v))-1",
                                            {-1, 1, 0, 30}, {}, Order::Second);
  for (const double tolerance : {0.1, 0.05, 0.03, 0.01, 5e-3, 5e-4}) {
    for (const int lines : {0, 7, 16}) {
      MeshRequest options = within_share(tolerance);
      options.lines = {lines, lines};
      const MeshResult result = try_mesh(surface, options).value();
      EXPECT_NEAR(area(result.mesh), 120, 1e-6) << tolerance << ' ' << lines;
      EXPECT_GE(result.report.jump_count, 30U) << tolerance << ' ' << lines;
    }
  }
}

/// At the line itself rounding may take the slope of either side.
TEST(Jumps, AtKinksTakeNoMoreCellsThanOthers) {
  const MeshResult plain =
      try_mesh(height_field("u>0.123+0.2*v?0.3:0"), within_share(1e-3)).value();
  const MeshResult kink =
      try_mesh(height_field("(u>0.123+0.2*v?0.3:0)+abs(u-0.123-0.2*v)"), within_share(1e-3))
          .value();
  EXPECT_EQ(kink.report.cells, plain.report.cells);
  EXPECT_LE(kink.report.max_error, *kink.report.tolerance);
}

/// A ribbon thickened by differences: its jumps are proportional to v.
TEST(Jumps, ThatFallBelowTheToleranceEndInAFewCells) {
  const std::string rise = "((0.29*step(0,cos(5*u))-0.29*step(0,cos(5*(u-0.01))))/0.01)";
  const std::string length = "hypot(1," + rise + ")";
  const Surface ribbon = surface_from_text("u-0.15*v*" + rise + "/" + length,
                                           "1+0.29*step(0,cos(5*u))+0.15*v/" + length, "v/2",
                                           {-2, 2, -1, 1}, {}, Order::Second);
  const MeshResult result = try_mesh(ribbon, within_share(1e-3)).value();
  EXPECT_LT(result.report.cells, 400U);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
}

/// Steps along an aslant line, each thinner or wider than the cells that it crosses.
TEST(Jumps, OnOneSideAreCutTogetherHoweverFarApart) {
  for (const char* const width : {"0.002", "0.07"}) {
    const std::string line = "floor(3*(u+v+" + std::string(width) + "))-floor(3*(u+v))";
    const MeshResult result =
        try_mesh(height_field(("0.2*(" + line + ")").c_str()), within_share(1e-3)).value();
    EXPECT_LT(result.report.cells, 400U) << width;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << width;
  }
}

TEST(Jumps, AlongASheetAreCutWhereNoSampleIsFarFromItsTriangles) {
  // Narrower than cells, or with their middle at the very place of the jump, half way.
  for (const char* const x :
       {"u+sign(u)", "u+0.02*sign(u-0.03)", "u+0.1*floor(3*u+0.5)", "u+0.02*floor(20*u)"}) {
    const MeshResult sheets = mesh_of(x, "v", "0", {-1, 1, -1, 1});
    EXPECT_GT(sheets.report.jump_count, 0U) << x;
    EXPECT_NEAR(area(sheets.mesh), 4, 1e-9) << x;
  }
  const MeshResult ring =
      mesh_of("cos(u)*(2+v+sign(v))", "sin(u)*(2+v+sign(v))", "0", {0, 2 * kPi, -1, 1});
  EXPECT_GT(ring.report.jump_count, 0U);
  EXPECT_NEAR(area(ring.mesh), 8 * kPi, 0.5);
}

TEST(Jumps, MayEndInsideOfTheSurface) {
  const MeshResult result = mesh_of("atan2(v,u)");
  EXPECT_GT(result.report.jump_count, 0U);
  EXPECT_EQ(result.report.pole_count, 0U);
  EXPECT_GT(area_in_uv(result.mesh), 4 * 0.9999);
  for (const Triangle& t : result.mesh.triangles) {
    for (const std::uint32_t corner : t) {
      if (middle_in_uv(result.mesh, t).x > 0) continue;
      const bool above = middle_in_uv(result.mesh, t).y > 0;
      ASSERT_EQ(result.mesh.position[corner].z > 0, above);
    }
  }
}

TEST(Creases, AreEdgesOfTheMeshWithANormalOnEitherSide) {
  const MeshResult result = mesh_of("abs(u-0.3*v)");
  const auto exact = [](const dvec2&, const dvec2& inside) {
    const double sign = inside.x > 0.3 * inside.y ? 1 : -1;
    return dvec3(-sign, 0.3 * sign, 1);
  };
  EXPECT_LT(worst_normal(result.mesh, exact), kThousandthDegree);
  EXPECT_EQ(euler_number(result.mesh), 1);
  EXPECT_LT(result.mesh.triangles.size(), 1500U);  // 450 without the crease
  EXPECT_LT(result.report.max_error, 1e-12);
}

TEST(Creases, GoThroughVerticesOfTheMesh) {
  for (const char* z : {"abs(u-v)", "abs(u+1/3)"}) {  // u = -1/3 is a grid line
    const MeshResult result = mesh_of(z);
    for (const Triangle& t : result.mesh.triangles) {
      const dvec3 face = glm::normalize(doubled_area(result.mesh, t));
      for (const std::uint32_t corner : t) {
        ASSERT_GT(glm::dot(face, result.mesh.normal[corner]), 1 - 1e-12) << z;
      }
    }
    EXPECT_EQ(euler_number(result.mesh), 1) << z;
  }
}

TEST(Creases, AtWhichTheSurfaceIsEverSteeperKeepTheTolerance) {
  // Walls: what is nearest to a place of theirs is far from its parameters in height.
  for (const char* z : {"abs(u)^0.2", "abs(u)^0.1", "1/ln(abs(u)/9)"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    EXPECT_LT(result.mesh.triangles.size(), 2000U) << z;
  }
  const MeshResult boundary = mesh_of("u", "v", "u^0.05", {0, 1, -1, 1});
  EXPECT_LE(boundary.report.max_error, *boundary.report.tolerance);
  EXPECT_LT(boundary.mesh.triangles.size(), 1500U);
}

TEST(Creases, ThatCrossLeaveNoCracks) {
  // At a point that is no vertex of the root grid; many at one; at a corner of a cell.
  for (const char* z : {"max(u,v)+abs(u+v)", "abs(u+v)+abs(u-v)", "max(u,v)+abs(u-2*v)",
                        "abs(u-0.1)+abs(v+u-0.21)+abs(u-3*v)"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_EQ(euler_number(result.mesh), 1) << z;
    EXPECT_NEAR(area_in_uv(result.mesh), 4, 1e-9) << z;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
  }
}

/// A crease that is a side of a cell but for rounding, on which the neighbours are finer.
TEST(Creases, OnLinesOfTheMeshLeaveNoCracks) {
  const struct {
    const char* z;
    double half;  // of the domain's sides
    double share;
    int lines;
  } cases[] = {{"max(0,1-abs(u)-abs(v))", 2, 1e-3, 16},
               {"min(abs(u),abs(v),0.7)", 3, 1e-3, 0},
               {"max(0,1-abs(u))*max(0,1-abs(v))", 3, 1e-3, 0}};
  for (const auto& [z, half, share, lines] : cases) {
    MeshRequest options = within_share(share, 3);
    options.lines = {lines, lines};
    const Surface surface = height_field(z, {-half, half, -half, half});
    const MeshResult result = try_mesh(surface, options).value();
    EXPECT_EQ(euler_number(result.mesh), 1) << z;
    EXPECT_NEAR(area_in_uv(result.mesh), 4 * half * half, 1e-9) << z;
  }
}

TEST(Creases, ThatEndWhereNobodySeesThemTakeNoTriangles) {
  // Through the centre, where r changes its sign, go creases that are one point of space.
  const std::string r = "(sin(4*v)^3+cos(2*v)^3+sin(6*u)^2+cos(6*u)^4)";
  const Surface surface =
      surface_from_text(r + "*sin(v)*cos(u)", r + "*cos(v)", r + "*sin(v)*sin(u)",
                        {0, 2 * kPi, 0, kPi}, {}, Order::Second);
  const MeshResult result = try_mesh(surface, within_share(0.01)).value();
  const auto& p = result.mesh.position;
  const auto is_small = [&](const Triangle& t) {
    const double longest =
        std::max({glm::distance(p[t[0]], p[t[1]]), glm::distance(p[t[1]], p[t[2]]),
                  glm::distance(p[t[2]], p[t[0]])});
    return longest < 0.25 * result.report.tolerance.value();
  };
  const auto& all = result.mesh.triangles;
  EXPECT_LT(std::ranges::count_if(all, is_small), std::ssize(all) / 100);
}

TEST(Creases, MayBeCurved) {
  const MeshResult result = mesh_of("abs(u^2+v^2-0.5)");
  const auto exact = [](const dvec2& uv, const dvec2& inside) {
    const double sign = glm::dot(inside, inside) > 0.5 ? 1 : -1;
    return dvec3(-2 * sign * uv, 1);
  };
  EXPECT_LT(worst_normal(result.mesh, exact), kThousandthDegree);
  EXPECT_EQ(euler_number(result.mesh), 1);
}

TEST(Creases, AtWhichTheSurfaceIsUprightKeepTheTolerance) {
  for (const char* z : {"sqrt(max(0,0.5-u^2-v^2))", "cbrt(max(0,0.5-u^2-v^2))", "abs(u-v^2)^0.3",
                        "abs(u-0.1)^0.4"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    EXPECT_EQ(std::ranges::count(result.report.singular_points, false, &SingularPoint::has_limit),
              0)
        << z;
    EXPECT_LT(result.mesh.triangles.size(), 20000U) << z;
    EXPECT_EQ(euler_number(result.mesh), 1) << z;
  }
}

/// Where a factor is 0 by structure, so is all that is made of the product.
TEST(Creases, HaveNormalsWhereAFactorIsZeroOnAPart) {
  for (const char* z :
       {"sqrt(max(0,u)*max(0,v))", "(min(0,u)*min(0,v))^0.4", "sqrt(max(0,u)*max(0,u+v))"}) {
    const std::vector<dvec2> flat = {{0.5, -0.6}, {-0.2, 0.1}};
    for (const SurfacePoint& point : evaluate(height_field(z), flat, 1)) {
      EXPECT_EQ(point.r_u, dvec3(1, 0, 0)) << z;
      EXPECT_EQ(point.r_v, dvec3(0, 1, 0)) << z;
    }
  }
}

TEST(Cusps, HaveTheOneSidedLimitsOfTheirNormals) {
  const MeshResult result = mesh_of("u", "(v-0.1)^2", "(v-0.1)^3", {-1, 1, -1, 1});
  const auto exact = [](const dvec2& uv, const dvec2& inside) {
    return dvec3(0, -3 * (uv.y - 0.1), 2) * (inside.y > 0.1 ? 1.0 : -1.0);
  };
  EXPECT_LT(worst_normal(result.mesh, exact), kThousandthDegree);
  EXPECT_EQ(triangles_against_normals(result.mesh), 0U);
  EXPECT_EQ(euler_number(result.mesh), 1);
}

TEST(Cusps, ThatAreCurvedAreCutToo) {
  // The swallowtail's cusps are where u + 6 v^2 = 0; its normal is along (1, v, v^2) everywhere.
  const MeshResult result = mesh_of("u*v^2+3*v^4", "-2*u*v-4*v^3", "u", {-2, 2, -0.8, 0.8});
  for (std::size_t k = 0; k < result.mesh.uv.size(); ++k) {
    const dvec2 uv = result.mesh.uv[k];
    if (glm::length(uv) < 0.1) continue;  // two cusps end in the one cell around the middle
    const double beyond = uv.x + 6 * uv.y * uv.y;
    const double cosine =
        glm::dot(glm::normalize(dvec3(1, uv.y, uv.y * uv.y)), result.mesh.normal[k]);
    const bool on_cusp = std::fabs(beyond) < 1e-12;
    ASSERT_GT(on_cusp ? std::fabs(cosine) : std::copysign(1.0, beyond) * cosine, 1 - 1e-12);
  }
  EXPECT_LT(result.report.max_normal_error, 3);
  EXPECT_EQ(euler_number(result.mesh), 1);
}

/// Whether a pole is reported, and none of the triangles has corners on both sides of it.
template <class Side>
void expect_cut(const char* z, Side side) {
  const MeshResult result = mesh_of(z);
  EXPECT_GT(result.report.pole_count, 0U) << z;
  for (const Triangle& t : result.mesh.triangles) {
    bool is_before = false;
    bool is_behind = false;
    for (const std::uint32_t corner : t) {
      is_before = is_before || side(result.mesh.uv[corner]) < 0;
      is_behind = is_behind || side(result.mesh.uv[corner]) > 0;
    }
    ASSERT_FALSE(is_before && is_behind) << z << " at " << middle_in_uv(result.mesh, t).x;
  }
}

TEST(Poles, OfEveryOrderAreCutAlongTheirLine) {
  for (const char* z : {"1/(u-0.3)", "1/(u-0.3)^2", "1/(u-0.3)^3", "1/(u-0.3)^4",
                        "1/sqrt(abs(u-0.3))", "ln(abs(u-0.3))"}) {
    expect_cut(z, [](const dvec2& uv) { return uv.x - 0.3; });
  }
  for (const char* z : {"1/(u-v)", "1/(u-v)^2"}) {
    expect_cut(z, [](const dvec2& uv) { return uv.x - uv.y; });
  }
}

TEST(Poles, ThatExceedDoublesBeforeTheSurfaceComesBackAreNoJumps) {
  // Infinite from u = -0.0014 on, and 0 at 0.
  const Surface surface = height_field("exp(-1/u)");
  for (const auto& [from, to] :
       {std::pair{-0.07, 0.07}, {-0.1, 0.08}, {-0.07, 0.0}, {0.0, -0.01}}) {
    std::size_t work = 0;
    const Line line = {dvec2(from, 0), dvec2(to, 0)};
    const LocatedDiscontinuity found =
        find_discontinuities(surface, std::span(&line, 1), 1e-2, 1, work)[0];
    EXPECT_EQ(found.kind, Discontinuity::Pole) << from;
    const auto [low, high] = std::minmax(found.ends[0].x, found.ends[1].x);
    EXPECT_NEAR(low, -1 / std::log(std::numeric_limits<double>::max()), 1e-9) << from;
    EXPECT_NEAR(high, 0, 1e-30) << from;
  }
}

TEST(Poles, AreNotWhatOscillates) {
  EXPECT_EQ(mesh_of("sin(1/u)").report.pole_count, 0U);
}

TEST(Jumps, HaveNoWallsBetweenTheirSides) {
  for (const char* z : {"floor(3*u)", "mod(u,0.4)", "sign(u*v-0.1)", "(u^2+v^2<0.5)?1:0"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_GT(result.report.jump_count, 0U) << z;
    EXPECT_EQ(result.report.pole_count, 0U) << z;
    for (const Triangle& t : result.mesh.triangles) {
      const dvec3 area = doubled_area(result.mesh, t);
      ASSERT_GT(area.z, 0.5 * glm::length(area)) << z;  // no wall: mod rises at 45 degrees
    }
    double covered = 0;
    for (const Triangle& t : result.mesh.triangles) covered += 0.5 * doubled_area(result.mesh, t).z;
    EXPECT_GT(covered, 4 * 0.97) << z;
  }
}

TEST(Jumps, AreNotSteepSlopesAndKinks) {
  for (const char* z :
       {"tanh(1e5*u)", "atan(1e6*u)", "sqrt(abs(u))", "abs(u-0.3*v)", "cbrt(u)", "exp(-1e6*u^2)"}) {
    const MeshResult result = mesh_of(z);
    EXPECT_EQ(result.report.jump_count + result.report.pole_count, 0U) << z;
    EXPECT_EQ(euler_number(result.mesh), 1) << z;
  }
}

/// At (0, 0) the height of the jump changes from pi to -pi.
TEST(Jumps, AreNotWhereASurfaceComesToItsValueEverMoreSlowly) {
  // 1/ln(u) comes to 0 at u = 0, but at the least of doubles it is still 0.001 away.
  const MeshResult result = mesh_of("u", "v", "1/ln(u/9)", {0, 1, -1, 1});
  EXPECT_EQ(result.report.jump_count, 0U);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
}

TEST(Jumps, HaveNormalsWhereTheFormulaIsBeyondDoubles) {
  const MeshResult result = mesh_of("1/(1+exp(1/u))");
  EXPECT_GT(result.report.jump_count, 0U);
  EXPECT_EQ(result.report.singular_point_count, 0U);
}

/// Where the jump goes along sides of cells, these are halved around the point, not toward the
/// jump.
TEST(Jumps, ThatMeetInAPointWithoutALimitTakeNoDenseMeshAroundIt) {
  for (const char* z :
       {"atan(v/u)", "atan(u/v)", "2*u*v/(u^2+v^2)+sign(u)", "erf(u/v)", "tanh(v/u)"}) {
    const MeshResult result = mesh_of(z);
    // The proof measures points next to the place without a limit, where no mesh is within 1.
    EXPECT_LE(result.report.max_error, 1.05 * *result.report.tolerance) << z;
    EXPECT_LT(result.mesh.triangles.size(), 10'000U) << z;
  }
}

TEST(Cuts, CountNoLineOnTheEdgeOfTheDomainAsSurface) {
  // floor(u) is 2 at u = 2 alone: x ends at 3, and the tolerance is a share of that box.
  const Surface steps =
      surface_from_text("u+floor(u)", "v", "0", {-2, 2, -1, 1}, {}, Order::Second);
  const MeshResult result = try_mesh(steps, within_share(1e-3)).value();
  const double diagonal = std::hypot(3.0 - -4.0, 2.0);
  // Samples end within 1/64 of the range of the edge that is left out.
  EXPECT_NEAR(*result.report.tolerance, 1e-3 * diagonal, 1e-3 * diagonal / 64);
  EXPECT_LE(result.mesh.bounds.high.x, 3);
  // Edges that the surface reaches steeply count.
  const Surface steep = height_field("(1-u)^-2", {-1, 0.9, -1, 1});
  EXPECT_NEAR(try_mesh(steep, within_share(1e-3)).value().mesh.bounds.high.z, 100, 1e-9);
}

}  // namespace
}  // namespace saddle
