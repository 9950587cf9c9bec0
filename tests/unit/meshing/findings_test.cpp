#include "meshing/findings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "mesh/model/mesh_report.h"
#include "meshing/clip_box.h"

namespace saddle {
namespace {

using Warnings = std::vector<std::string>;

/// A mesh whose corners span these parameters.
MeshResult mesh_between(dvec2 low, dvec2 high) {
  MeshResult result;
  result.mesh.uv = {low, {high.x, low.y}, {low.x, high.y}, high};
  return result;
}

const Domain kDomain{-1, 1, 0, 2};

Warnings mesh_warnings(const std::string& name, const MeshResult& mesh, const Domain& domain) {
  return warnings_of(name, mesh_findings(mesh, domain));
}

TEST(Warnings, AreNoneForACleanSurface) {
  EXPECT_TRUE(mesh_warnings("s", mesh_between({-1, 0}, {1, 2}), kDomain).empty());
}

TEST(Warnings, SayHowMuchIsUndefinedAndWhere) {
  MeshResult part = mesh_between({-0.5, 0}, {1, 2});
  part.report.undefined_fraction = 0.25;
  EXPECT_EQ(mesh_warnings("s", part, kDomain),
            Warnings{"s: 25 % of the domain is undefined and left out, at least outside of "
                     "u = -0.5:1"});
  part = mesh_between({-0.5, 0.25}, {1, 2});
  part.report.undefined_fraction = 0.123456;
  EXPECT_EQ(mesh_warnings("s", part, kDomain),
            Warnings{"s: 12.35 % of the domain is undefined and left out, at least outside of "
                     "u = -0.5:1, v = 0.25:2"});
  part.report.exceeds_doubles = true;
  EXPECT_EQ(mesh_warnings("s", part, kDomain),
            Warnings{"s: 12.35 % of the domain is larger than doubles can hold and left out, at "
                     "least outside of u = -0.5:1, v = 0.25:2"});
}

TEST(Warnings, TakeTheRoundingOfAnEndForZero) {
  MeshResult part = mesh_between({6.2e-34, 0}, {1, 2});
  part.report.undefined_fraction = 0.5;
  EXPECT_EQ(mesh_warnings("s", part, kDomain),
            Warnings{"s: 50 % of the domain is undefined and left out, at least outside of "
                     "u = 0:1"});
}

TEST(Warnings, NameTheLimitThatLeftNormalsCoarse) {
  MeshResult coarse = mesh_between({-1, 0}, {1, 2});
  coarse.report.max_error = 2;
  coarse.report.max_normal_error = 5;
  coarse.report.coarse_normals = {0, 1};
  coarse.report.shortage = Shortage::Time;
  EXPECT_EQ(mesh_warnings("s", coarse, kDomain).back(),
            "s: normals turn faster than its triangles show, by up to 5 degrees, as at u = 0, "
            "v = 1; --max-time allows more");
  coarse.report.shortage = Shortage::None;
  EXPECT_TRUE(mesh_warnings("s", coarse, kDomain).back().ends_with("--max-triangles allows more"));
}

TEST(Warnings, SayThatFewerSurfacesHaveLargerSharesOfTheLimits) {
  MeshResult coarse = mesh_between({-1, 0}, {1, 2});
  coarse.report.tolerance = 1e-3;
  coarse.report.max_error = 2e-3;
  coarse.report.reached_limit = true;
  const auto text_of = [&coarse](bool shares_limits) {
    return mesh_findings(coarse, kDomain, shares_limits).back().text;
  };
  EXPECT_TRUE(text_of(true).ends_with("; fewer surfaces or --max-triangles allows more"));
  coarse.report.budget_spent = true;
  EXPECT_TRUE(text_of(true).ends_with(
      "; fewer surfaces or smaller ranges show more, --max-triangles allows more work"));
  EXPECT_EQ(text_of(false).find("fewer surfaces"), std::string::npos);
}

TEST(Warnings, NameTheTrianglesThatAToleranceNeeds) {
  MeshResult coarse = mesh_between({-1, 0}, {1, 2});
  coarse.report.tolerance = 1e-3;
  coarse.report.max_error = 2e-3;
  coarse.report.reached_limit = true;
  coarse.report.least_triangles = 12'345'678;
  EXPECT_EQ(mesh_warnings("s", coarse, kDomain),
            Warnings{"s: the limit of triangles stopped refinement, the mesh is off by at least "
                     "0.002 (the tolerance is 0.001); --max-triangles allows more, the tolerance "
                     "needs 12000000 at least"});
  coarse.report.least_triangles = 0;  // unknown
  EXPECT_TRUE(mesh_warnings("s", coarse, kDomain).back().ends_with("--max-triangles allows more"));
}

TEST(Warnings, DoNotSayThatAMeshIsOffThatALimitLeftWithinItsTolerance) {
  MeshResult stopped = mesh_between({-1, 0}, {1, 2});
  stopped.report.tolerance = 1e-3;
  stopped.report.max_error = 1e-3;
  stopped.report.budget_spent = true;
  EXPECT_EQ(mesh_warnings("s", stopped, kDomain),
            Warnings{"s: the limit of work stopped refinement: errors above the tolerance, "
                     "0.001, may hide; smaller ranges show more, "
                     "--max-triangles allows more work"});
  stopped.report.max_error = 1.1e-3;
  EXPECT_NE(mesh_warnings("s", stopped, kDomain).back().find("the mesh is off by at least 0.0011"),
            std::string::npos);
}

TEST(Warnings, NameTheFacesOfTheBoxThatCut) {
  MeshResult cut = mesh_between({-1, 0}, {1, 2});
  cut.report.clip = Bounds{{-kInfinity, -2, 3}, {4, 5, kInfinity}};
  cut.report.poles = {{0, 1}};
  cut.report.pole_count = 1;
  EXPECT_EQ(mesh_warnings("s", cut, kDomain).back(),
            "s: clipped to x up to 4, y = -2:5, z from 3 up; --clip off shows all of it");
  cut.report.poles.clear();
  cut.report.pole_count = 0;
  EXPECT_EQ(mesh_warnings("s", cut, kDomain),
            Warnings{"s: x, y and z are out of proportion: clipped to x up to 4, y = -2:5, z from "
                     "3 up; --clip off shows all of it"});
  // A thin slice far from 0 is alike in its first digits.
  cut.report.clip = Bounds{{-kInfinity, -kInfinity, 273653}, {kInfinity, kInfinity, 273731}};
  EXPECT_EQ(mesh_warnings("s", cut, kDomain),
            Warnings{"s: x, y and z are out of proportion: clipped to z = 2.7365e+05:2.7373e+05; "
                     "--clip off shows all of it"});
  cut.report.clip = Bounds{dvec3(-kInfinity), dvec3(kInfinity)};
  EXPECT_TRUE(mesh_warnings("s", cut, kDomain).empty());
}

TEST(Warnings, DoNotSayWhereASurfaceIsDefinedThatABoxCuts) {
  MeshResult cut = mesh_between({-0.1, 0}, {0.1, 2});
  cut.report.undefined_fraction = 0.25;
  cut.report.is_clipped = true;
  EXPECT_EQ(mesh_warnings("s", cut, kDomain),
            Warnings{"s: 25 % of the domain is undefined and left out"});
}

TEST(Warnings, NamePointsThatHaveNoLimit) {
  MeshResult torn = mesh_between({-1, 0}, {1, 2});
  torn.report.without_limit = torn.report.jumps = {{0, 1}};
  torn.report.jump_count = 1;
  EXPECT_EQ(mesh_warnings("s", torn, kDomain),
            Warnings{"s: the surface has no limit at u = 0, v = 1: each way there leads to another "
                     "place; left out"});
  torn.report.without_limit =
      torn.report.jumps = {{-7e-21, 1e-11}};  // what a bisection takes for 0; near it
  EXPECT_NE(mesh_warnings("s", torn, kDomain)[0].find("at u = 0, v = 1e-11:"), std::string::npos);
  torn.report.without_limit = torn.report.jumps = {{0, 1}, {1, 1}, {0.5, 1}};
  torn.report.jumps.emplace_back(0.25, 1);
  torn.report.jump_count = 6;
  const Warnings both = mesh_warnings("s", torn, kDomain);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[0], "s: the surface jumps and is cut there: u = 0.25, v = 1; and others");
  EXPECT_NE(both[1].find("u = 0, v = 1 and 2 other points"), std::string::npos) << both[1];
}

/// A grid of another size cuts at other places of the same lines.
TEST(Warnings, TellTheLinesOfJumpsNotHowManyPlacesWereCut) {
  const auto warning = [](int cells) {
    MeshResult jumps = mesh_between({-1, 0}, {1, 2});
    for (int k = 0; k <= cells; ++k) {
      jumps.report.jumps.emplace_back(0.5, 2.0 * k / cells);
      jumps.report.jumps.emplace_back(-1 + 2.0 * k / cells, 1e-21);
    }
    jumps.report.jump_count = jumps.report.jumps.size();
    return mesh_warnings("s", jumps, kDomain);
  };
  EXPECT_EQ(warning(20),
            Warnings{"s: the surface jumps and is cut there: u = -1:1, v = 0; u = 0.5, v = 0:2"});
  EXPECT_EQ(warning(33), warning(20));
}

/// Twenty slanted curves cut each row of the grid at twenty places.
TEST(Warnings, TellNoLineOfTheGridForManyCurvesThatCrossIt) {
  MeshResult jumps = mesh_between({-1, 0}, {1, 2});
  for (int curve = 0; curve < 20; ++curve) {
    for (int row = 0; row < 40; ++row) {
      jumps.report.jumps.emplace_back(-1 + 0.1 * curve + 0.002 * row, row / 20.0);
    }
  }
  jumps.report.jump_count = jumps.report.jumps.size();
  EXPECT_EQ(mesh_warnings("s", jumps, kDomain),
            Warnings{"s: the surface jumps and is cut there: within u = -1:0.978, v = 0:1.95"});
}

TEST(Warnings, TellABoxOfJumpsAlongACurve) {
  MeshResult jumps = mesh_between({-1, 0}, {1, 2});
  for (int k = 0; k < 8; ++k) {
    const double turn = k * std::numbers::pi / 4;
    jumps.report.jumps.emplace_back(0.5 * std::cos(turn), 1 + 0.5 * std::sin(turn));
  }
  jumps.report.jump_count = jumps.report.jumps.size();
  EXPECT_EQ(mesh_warnings("s", jumps, kDomain),
            Warnings{"s: the surface jumps and is cut there: within u = -0.5:0.5, v = 0.5:1.5"});
}

TEST(Warnings, SayThatASurfaceIsOneSided) {
  MeshResult band = mesh_between({-1, 0}, {1, 2});
  band.report.orientable = false;
  EXPECT_EQ(mesh_warnings("s", band, kDomain),
            Warnings{"s: the surface is one-sided: front and back meet along a line"});
}

TEST(Warnings, SayThatARangeRunsBackwards) {
  EXPECT_EQ(mesh_warnings("s", mesh_between({-1, 0}, {1, 2}), {1, -1, 0, 2}),
            Warnings{"s: a range runs backwards, which swaps front and back"});
}

TEST(Warnings, SayThatHolesAreInPlaces) {
  MeshResult holes = mesh_between({-1, 0}, {1, 2});
  holes.report.undefined_fraction = 0.01;
  const Domain backwards{1, -1, 2, 0};
  for (const Domain& domain : {kDomain, backwards}) {
    EXPECT_EQ(mesh_warnings("s", holes, domain),
              Warnings{"s: 1 % of the domain is undefined and left out, in places across the "
                       "ranges"});
  }
}

TEST(Warnings, TakeNoRangeForAPartThatIsPrintedLikeTheWhole) {
  MeshResult holes = mesh_between({-1 + 1e-9, 0}, {1, 2});
  holes.report.undefined_fraction = 0.01;
  EXPECT_EQ(mesh_warnings("s", holes, kDomain),
            Warnings{"s: 1 % of the domain is undefined and left out, in places across the "
                     "ranges"});
}

TEST(Warnings, CountSingularPointsWithoutANormal) {
  MeshResult singular = mesh_between({-1, 0}, {1, 2});
  singular.report.singular_points = {{{0, 1}, true}, {{-0.0, 0.5}, false}};
  singular.report.singular_point_count = 2;
  singular.report.singular_in_space = {{{0, 1}, dvec3(0), {0}}, {{0, 0.5}, dvec3(1), {1}}};
  EXPECT_EQ(mesh_warnings("s", singular, kDomain),
            Warnings{"s: 1 singular point has no normal (the first at u = 0, v = 0.5): the faces' "
                     "are drawn there"});
  singular.report.singular_points.push_back({{1, 1}, false});
  singular.report.singular_in_space.push_back({{1, 1}, dvec3(2), {2}});
  singular.report.singular_point_count = 5000;  // more than the list holds
  EXPECT_EQ(mesh_warnings("s", singular, kDomain),
            Warnings{"s: at least 2 singular points have no normal (the first at u = 0, v = 0.5): "
                     "the faces' are drawn there"});
}

TEST(Warnings, CountPlacesAtOnePointOnce) {
  MeshResult apex = mesh_between({-1, 0}, {1, 2});
  apex.report.singular_points = {{{0, 0}, false}, {{0.5, 0}, false}, {{1, 0}, false}};
  apex.report.singular_point_count = 3;
  apex.report.singular_in_space = {{{0, 0}, dvec3(0), {0, 1, 2}}};
  EXPECT_EQ(mesh_warnings("s", apex, kDomain),
            Warnings{"s: 1 singular point has no normal (the first at u = 0, v = 0): the faces' "
                     "are drawn there"});
}

TEST(Warnings, SayThatDoublesRoundLargeCoordinates) {
  MeshResult far = mesh_between({-1, 0}, {1, 2});
  far.report.tolerance = 0.01;
  far.report.max_error = 0.5;
  far.report.rounding = 0.125;
  EXPECT_EQ(mesh_warnings("s", far, kDomain),
            Warnings{"s: the mesh is off by at least 0.5 (the tolerance is 0.01): its coordinates "
                     "are so large that doubles round them by 0.125; subtract what they have in "
                     "common"});
}

TEST(Findings, HaveTheNumbersOfTheirSentences) {
  MeshResult off = mesh_between({-1, 0}, {1, 2});
  off.report.tolerance = 0.01;
  off.report.max_error = 0.5;
  off.report.worst_place = dvec2(0.25, 1);
  const std::vector<Finding> findings = mesh_findings(off, kDomain);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(name_of(findings[0].kind), "off-tolerance");
  EXPECT_TRUE(findings[0].warns);
  EXPECT_EQ(findings[0].value, 0.5);
  EXPECT_EQ(findings[0].unit, "length");
  EXPECT_EQ(findings[0].place->low, dvec2(0.25, 1));
  EXPECT_NE(findings[0].text.find("off by at least 0.5 (the tolerance is 0.01)"), std::string::npos)
      << findings[0].text;
}

/// A mesh with one gap that leaves room for a feature of a height, in tolerances.
MeshResult mesh_with_gap(double share, double room) {
  MeshResult result = mesh_between({-1, 0}, {1, 2});
  result.report.tolerance = 0.01;
  ProofGap gap{GapReason::Wide, {0.25, 0}, {0.3, 2}, share};
  gap.visible = room > 0 ? share : 0;
  gap.width = 0.01;
  gap.room = room * 0.01;
  gap.worst = {0.25, 1};
  result.report.proof_gaps = {gap};
  return result;
}

TEST(Findings, WarnOfASmallUnprovedPartWithRoomForALargeFeature) {
  const MeshResult ridge = mesh_with_gap(0.005, 350);
  const std::vector<Finding> findings = mesh_findings(ridge, kDomain);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(name_of(findings[0].kind), "unproved");
  EXPECT_EQ(findings[0].share, 0.005);
  EXPECT_EQ(findings[0].value, 0.01);
  EXPECT_EQ(findings[0].place->high, dvec2(0.3, 2));
  EXPECT_TRUE(findings[0].warns);
  EXPECT_EQ(findings[0].text,
            "a feature up to 3.5 high and narrower than 0.01 could be missing near u = 0.25, v = "
            "1: 0.5 % of the domain is not proved; second derivatives are too large, or their "
            "bounds too wide");
}

TEST(Findings, DoNotWarnOfWideBoundsEverywhereOrWithoutRoom) {
  for (const MeshResult& smooth :
       {mesh_with_gap(0.3, 350), mesh_with_gap(0.005, 0), mesh_with_gap(0.005, 8)}) {
    const std::vector<Finding> findings = mesh_findings(smooth, kDomain);
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_FALSE(findings[0].warns) << findings[0].text;
  }
}

}  // namespace
}  // namespace saddle
