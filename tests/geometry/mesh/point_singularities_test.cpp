// Points and lines where a surface is not defined: what there is around them, and their meshes.
#include "mesh/features/point_singularities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/topology.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface/normal.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

PointSingularity hole_at(const std::string& z, const dvec2& place,
                         const Domain& domain = {-1, 1, -1, 1}) {
  const std::vector<dvec2> places = {place};
  return classify_points(height_field(z, domain), places, 3, 1).at(0);
}

TEST(Holes, AreToldApart) {
  using Kind = PointSingularity::Kind;
  const struct {
    const char* z;
    dvec2 place;
    Kind kind;
  } cases[] = {
      {"sqrt(u)", {-0.5, 0}, Kind::Region},
      {"ln(u)", {0, 0.2}, Kind::Region},
      {"1/u", {0, 0.2}, Kind::Line},
      {"1/(u^2-v^2)", {0.5, 0.5}, Kind::Line},
      {"1/(u+1)", {-1, 0.2}, Kind::Line},  // on the edge of the domain
      {"1/(u^2+v^2)", {0, 0}, Kind::Pole},
      {"ln(u^2+v^2)", {0, 0}, Kind::Pole},
      {"u/(u^2+v^2)", {0, 0}, Kind::Pole},         // 0 along v
      {"u*v/(u^2+v^2)^2", {0, 0}, Kind::Pole},     // 0 along both
      {"u*v/(u^2+v^2)", {0, 0}, Kind::Essential},  // 0 along both, too
      {"sin(1/(u^2+v^2))", {0, 0}, Kind::Essential},
      {"(u^2+v^2)^0.1*u/sqrt(u^2+v^2)", {0, 0}, Kind::Removable},
      // 0 on all straight ways, and 1/2 on v = u^2, u = v^2, v = u^3, v = u^4, and aslant
      {"u^2*v/(u^4+v^2)", {0, 0}, Kind::Essential},
      {"u*v^2/(u^2+v^4)", {0, 0}, Kind::Essential},
      {"u^3*v/(u^6+v^2)", {0, 0}, Kind::Essential},
      {"u^4*v/(u^8+v^2)", {0, 0}, Kind::Essential},
      {"(u+v)^2*(u-v)/((u+v)^4+(u-v)^2)", {0, 0}, Kind::Essential},
      {"(u-0.3)^2*(v+0.2)/((u-0.3)^4+(v+0.2)^2)", {0.3, -0.2}, Kind::Essential},
      {"u^3*v/(u^4+v^2)", {0, 0}, Kind::Removable},  // at most abs(u)/2
      {"(1-cos(hypot(u,v)))/(u^2+v^2)", {0, 0}, Kind::Removable},
  };
  for (const auto& [z, place, kind] : cases) {
    EXPECT_EQ(static_cast<int>(hole_at(z, place).kind), static_cast<int>(kind)) << z;
  }
  const Domain quarter{0, 1, 0, 1};
  EXPECT_EQ(hole_at("u*v/(u^2+v^2)", {0, 0}, quarter).kind, Kind::Essential) << "from one quarter";
  EXPECT_EQ(hole_at("u^2*v/(u^4+v^2)", {0, 0}, quarter).kind, Kind::Essential);
  EXPECT_GT(hole_at("u*v/(u^2+v^2)^2", {0, 0}).near.high.z, 1e18);
}

MeshResult mesh_of(const Surface& surface, double tolerance,
                   const std::optional<Bounds>& clip = {}) {
  MeshRequest options = within_length(tolerance);
  options.clip = clip;
  return try_mesh(surface, options).value();
}

TEST(Holes, WithoutALimitAreNamedAndLeftOut) {
  const MeshResult result = mesh_of(height_field("2*u*v/(u^2+v^2)"), 3e-3);
  ASSERT_EQ(result.report.without_limit.size(), 1U);
  EXPECT_LT(glm::length(result.report.without_limit[0]), 1e-12);
  EXPECT_EQ(result.report.jump_count, 1U);
  EXPECT_EQ(result.report.pole_count, 0U);
  EXPECT_EQ(result.report.undefined_fraction, 0);
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_EQ(euler_number(result.mesh), 0) << "one hole";
  double singularity = 4;
  for (const Triangle& t : result.mesh.triangles) {
    const dvec2 a = result.mesh.uv[t[1]] - result.mesh.uv[t[0]];
    const dvec2 b = result.mesh.uv[t[2]] - result.mesh.uv[t[0]];
    singularity -= 0.5 * std::fabs(a.x * b.y - a.y * b.x);
  }
  EXPECT_LT(singularity, 4e-5) << "no wider than two tolerances";
  EXPECT_GT(singularity, 0);
}

/// Each straight way to the point has the limit 0, and the surface is defined beside it: its vertex
/// is not filled in.
TEST(Holes, WithoutALimitAlongCurvesAreNamedAndLeftOut) {
  for (const auto& [z, place] : {std::pair("u^2*v/(u^4+v^2)", dvec2(0)),
                                 std::pair("(u-0.3)^2*v/((u-0.3)^4+v^2)", dvec2(0.3, 0))}) {
    for (const int lines : {0, 16, 17}) {
      MeshRequest options = within_share(1e-3);
      options.lines = {lines, lines};
      const MeshReport report = try_mesh(height_field(z), options).value().report;
      // A ridge narrower than any cell leads to the point.
      EXPECT_LE(report.max_error, 2 * *report.tolerance) << z << ' ' << lines;
      ASSERT_EQ(report.without_limit.size(), 1U) << z << ' ' << lines;
      EXPECT_LT(glm::distance(report.without_limit[0], place), 1e-12) << z << ' ' << lines;
      EXPECT_EQ(report.singular_point_count, 0U) << z << ' ' << lines;
    }
  }
}

/// Bounds leave room for a jump along all of the line on which atan2 has one: that goes through the
/// point, which is a vertex with a value for 17 lines, and in the midst of a leaf for 16.
TEST(Holes, WithoutALimitOnALineThatBoundsDoubtAreNamedAndLeftOut) {
  for (const char* const z : {"sin(3*atan2(v,u))", "sin(2*atan2(v,u))", "cos(2*atan2(v,u))"}) {
    for (const int lines : {16, 17}) {
      MeshRequest options = within_share(1e-3, 3);
      options.lines = {lines, lines};
      const MeshReport report = try_mesh(height_field(z), options).value().report;
      EXPECT_LE(report.max_error, *report.tolerance) << z << ' ' << lines;
      ASSERT_EQ(report.without_limit.size(), 1U) << z << ' ' << lines;
      EXPECT_LT(glm::length(report.without_limit[0]), 1e-12) << z << ' ' << lines;
    }
  }
}

/// A line of jumps through corners of leaves is one point of each: ways there lead to as many
/// places as it has sides, and sign(0) is one more.
TEST(Holes, AreNoneAlongLinesOfJumps) {
  for (const auto& [z, parts] : {std::pair("sign(u-v)", 2U), std::pair("sign(u^2-v^2)", 4U)}) {
    const MeshResult result = mesh_of(height_field(z), 3e-3);
    EXPECT_TRUE(result.report.without_limit.empty()) << z;
    EXPECT_EQ(topology(result.mesh).components, parts) << z;
  }
}

TEST(Holes, ThatArePolesFromSomeSidesAreNamed) {
  const MeshReport report =
      try_mesh(height_field("u*v/(u^2+v^2)^2"), within_share(1e-3)).value().report;
  EXPECT_GT(report.pole_count, 0U);
  EXPECT_TRUE(report.without_limit.empty());
}

TEST(Holes, ThatArePolesAreNamedAndWithinTolerance) {
  const Bounds box{{-1, -1, -3}, {1, 1, 3}};
  for (const char* z : {"u/(u^2+v^2)", "(u^2-v^2)/(u^2+v^2)^2", "1/u+1/v", "1/(u^2-v^2)"}) {
    const Surface surface = height_field(z);
    const MeshReport whole = try_mesh(surface, within_share(1e-3)).value().report;
    EXPECT_GT(whole.pole_count, 0U) << z;
    EXPECT_GT(whole.beside_poles.high.z, 1e3) << z;
    EXPECT_LT(whole.beside_poles.low.z, -1e3) << z;
    const MeshResult result = mesh_of(surface, 1e-2, box);
    EXPECT_TRUE(result.report.without_limit.empty()) << z;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    EXPECT_EQ(result.report.undefined_fraction, 0) << z << " is defined but on points and lines";
  }
}

TEST(Holes, OfACircleOfLimitsAreNotCutAcross) {
  // A cylinder: ways to (0, 0) lead to all of its lower edge.
  const Surface surface = surface_from_text("u/hypot(u,v)", "v/hypot(u,v)", "hypot(u,v)",
                                            {-1, 1, -1, 1}, {}, Order::Second);
  constexpr double kTolerance = 3e-3;
  const auto mesh = try_mesh(surface, within_length(kTolerance));
  ASSERT_TRUE(mesh);
  EXPECT_LE(mesh->report.max_error, kTolerance);
  const auto& p = mesh->mesh.position;
  for (const Triangle& t : mesh->mesh.triangles) {
    const dvec3 middle = (p[t[0]] + p[t[1]] + p[t[2]]) / 3.0;
    ASSERT_GT(glm::length(dvec2(middle)), 1 - 2 * kTolerance);
  }
}

TEST(Holes, AlongDiagonalsOfCellsThatHaveLimitsAreRegular) {
  const MeshResult result = mesh_of(height_field("(u^3-v^3)/(u-v)"), 4e-3);
  EXPECT_EQ(result.report.singular_point_count, 0U);
  std::size_t on_diagonal = 0;
  for (std::size_t k = 0; k < result.mesh.uv.size(); ++k) {
    const dvec2 uv = result.mesh.uv[k];
    if (uv.x != uv.y) continue;
    ++on_diagonal;
    const dvec3 normal = glm::normalize(dvec3(-3 * uv.x, -3 * uv.x, 1));  // of u^2 + u v + v^2
    EXPECT_LE(degrees_between(result.mesh.normal[k], normal), 1e-2) << uv.x;
    EXPECT_NEAR(result.mesh.position[k].z, 3 * uv.x * uv.x, 1e-9) << uv.x;
  }
  EXPECT_GE(on_diagonal, 10U);
  // On a crease they have several normals.
  EXPECT_GE(mesh_of(height_field("(u^2-v^2)/(u-v)+2*abs(u-v)"), 4e-3).report.singular_point_count,
            10U);
}

TEST(Holes, ThatAreRoundingInPlaceOf0Over0AreFilled) {
  // Where both ranges have lines that are as good as the same, u - v is one digit.
  for (const char* z : {"(u^3-v^3)/(u-v)", "(exp(u)-exp(v))/(u-v)"}) {
    for (const double end : {0.7, 1.0}) {
      MeshRequest options = within_share(1e-3, 3);
      options.lines = {15, 15};
      const MeshResult result = try_mesh(height_field(z, {0, end, 0, 2 * end}), options).value();
      EXPECT_LE(result.report.max_error, *result.report.tolerance) << z << ' ' << end;
      EXPECT_EQ(result.report.jump_count, 0U) << z << ' ' << end;
    }
  }
}

TEST(Holes, BetweenSheetsAreTakenToOneOfThem) {
  const auto at = [](const char* z, const dvec2& place) {
    const std::vector<dvec2> places = {place};
    std::size_t count = 0;
    return points_beside_jumps(height_field(z), places, 3, 1, count).at(0);
  };
  const auto beside = at("(u-v)/abs(u-v)", {0.5, 0.5});
  ASSERT_TRUE(beside.has_value());
  EXPECT_EQ(std::fabs(beside->point.position.z), 1);
  EXPECT_LT(glm::distance(beside->uv, dvec2(0.5)), 1e-11);
  EXPECT_TRUE(at("(u^2-v^2)/abs(u^2-v^2)", {0, 0}));  // where two lines cross
  EXPECT_TRUE(at("(u-v)/abs(u-v)", {1, 1}));          // at the corner of the domain
  EXPECT_FALSE(at("u*v/(u^2+v^2)", {0, 0}));          // many limits
  EXPECT_FALSE(at("1/(u-v)", {0.5, 0.5}));
  EXPECT_FALSE(at("sqrt(u-v)", {0.5, 0.5}));
  EXPECT_FALSE(at("sin(u-v)/(u-v)", {0.5, 0.5}));  // one limit
}

TEST(Holes, BetweenSheetsCostNoMoreThanOtherJumps) {
  // In cells whose corners are on the jump, and in others.
  for (const char* z : {"(u-v)/abs(u-v)", "(u-0.31*v)/abs(u-0.31*v)", "(u^2-v^2)/abs(u^2-v^2)"}) {
    const MeshResult result = try_mesh(height_field(z), within_share(1e-3, 3)).value();
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    EXPECT_LT(result.mesh.triangles.size(), 2000U) << z;
    EXPECT_GT(result.report.jump_count, 0U) << z;
    EXPECT_EQ(result.report.undefined_fraction, 0) << z;
  }
}

TEST(Holes, ThatHaveALimitAreFilled) {
  MeshRequest options = within_share(1e-3, 3);
  options.lines = {17, 17};  // one each through the middle
  const MeshResult result =
      try_mesh(height_field("sin(sqrt(u^2+v^2))/sqrt(u^2+v^2)", {-9, 9, -9, 9}), options).value();
  EXPECT_EQ(result.report.undefined_fraction, 0);
  EXPECT_NEAR(result.mesh.bounds.high.z, 1, 1e-9);
  EXPECT_EQ(euler_number(result.mesh), 1);
}

}  // namespace
}  // namespace saddle
