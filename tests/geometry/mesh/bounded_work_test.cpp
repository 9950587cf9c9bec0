// Where halving finds no end of its own: work is bounded, and the report says where.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "mesh/mesher/mesh_plan.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/triangle_tree.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshRequest thousandth() {
  return within_share(1e-3, 3);
}

TEST(BoundedWork, EndsWhereWavesAreNarrowerThanPixelsWhateverTheirShape) {
  // Rings; a line of waves that is less than a pixel wide.
  for (const char* z : {"sin(1e-3/(u^2+v^2))", "sin(1e-3/u)"}) {
    const MeshResult result = try_mesh(height_field(z), thousandth()).value();
    EXPECT_FALSE(result.report.reached_limit) << z;
    EXPECT_LT(result.report.evaluations, 1'000'000U) << z;
    // The waves fill less than a tolerance: triangles beside a cell are near its waves.
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
    ASSERT_TRUE(result.report.oscillates) << z;
    // No farther from where the waves are than some widths of the last ones that show.
    EXPECT_LT(
        std::min(std::fabs(result.report.oscillates->x), std::fabs(result.report.oscillates->y)),
        0.05)
        << z;
  }
}

TEST(BoundedWork, TellsHowFarWavesAreFromAllTriangles) {
  // Their own cells' triangles are as far as waves are high, 577 tolerances. Before vertices move
  // to extremes the largest distance is half of that from the mesh that is written.
  for (const double height : {1.0, 0.1}) {
    const Surface surface = height_field((std::to_string(height) + "*sin(1/u)").c_str());
    const MeshResult result = try_mesh(surface, thousandth()).value();
    ASSERT_TRUE(result.report.oscillates);
    const TriangleTree tree(result.mesh);
    double farthest = 0;
    for (const double v : {-1.0, 0.31, 0.9, 1.0}) {  // farthest at an edge
      for (int k = 1; k <= 20'000; ++k) {
        const double u = k * 1e-6;
        farthest = std::max(farthest, tree.distance({u, v, height * std::sin(1 / u)}));
      }
    }
    EXPECT_GT(farthest, *result.report.tolerance);
    EXPECT_GE(result.report.max_error, 0.9 * farthest);
    EXPECT_LE(result.report.max_error, 1.5 * farthest);
  }
}

TEST(BoundedWork, EndsWhereWavesCrowdAlongASlantingLine) {
  for (const char* z : {"sin(0.1/(u+v))", "sin(0.03/(u-2*v))", "sin(1/(u*v))"}) {
    const MeshResult result = try_mesh(height_field(z), thousandth()).value();
    EXPECT_FALSE(result.report.reached_limit) << z;
    EXPECT_TRUE(result.report.oscillates) << z;
    // At most 10.01 million, of which a tenth looks for jumps beside jumps; 25 million where leaves
    // beside the blocks that waves fill are halved further.
    EXPECT_LT(result.report.evaluations, 12'000'000U) << z;
  }
}

TEST(BoundedWork, TakesNoMoreCellsForWavesThanTheirToleranceShows) {
  // Nowhere are there many more cells than four tolerances each way, 250 by 250, halved now and
  // then; along u alone a few hundred, fifteen times between drawn lines.
  for (const auto& [z, most] :
       {std::pair("sin(1e6*u*v+1e5*u)", 1'000'000U), std::pair("sin(1e6*u)", 60'000U)}) {
    MeshRequest options = thousandth();
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_FALSE(result.report.reached_limit) << z;
    EXPECT_TRUE(result.report.oscillates) << z;
    EXPECT_LT(result.mesh.triangles.size(), most) << z;
    // Six for each triangle, and a quarter as many for proofs.
    EXPECT_LT(result.report.evaluations, 8 * most) << z;
  }
}

TEST(BoundedWork, ForeseesWavesThatNoMeshCouldFollow) {
  for (const char* z : {"sin(1e4*u*v)", "sin(exp(20*u)*v)", "sin(1e15*u)"}) {
    const MeshResult result = try_mesh(height_field(z), thousandth()).value();
    EXPECT_FALSE(result.report.reached_limit) << z;
    EXPECT_TRUE(result.report.oscillates) << z;
    // Cells of four tolerances, halved once and now and then twice, on nine places each, and the
    // sides of thin triangles.
    EXPECT_LT(result.report.evaluations, 3'000'000U) << z;
    EXPECT_LT(result.mesh.triangles.size(), 300'000U) << z;
  }
}

TEST(BoundedWork, LooksForNearSheetsWithAPartOfTheWorkOfTheMesh) {
  // Sheets of waves lie so close together that a point's nearest triangle is found only after a
  // visit of most: for all parts of the mesh that would take ten times its work.
  MeshRequest options = within_share(1e-3, 3);
  options.max_triangles = 200'000;
  const Surface tangle = surface_from_text("sin(100*u*v)", "cos(130*u+v)", "sin(170*v-u*u)",
                                           {-1, 1, -1, 1}, {}, Order::Second);
  const MeshResult result = try_mesh(tangle, options).value();
  EXPECT_TRUE(result.report.reached_limit);
  EXPECT_GT(result.report.max_error, *result.report.tolerance);
  EXPECT_LT(tangle.tangents.count->with_work(), 5 * tangle.tangents.count->total());
}

TEST(BoundedWork, SearchesAMeshThatTheLimitStoppedOnce) {
  MeshRequest options = within_share(1e-9, 3);
  options.max_triangles = 40'000;
  const Surface sphere = surface_from_text("cos(u)*cos(v)", "sin(u)*cos(v)", "sin(v)",
                                           {0, 2 * kPi, -kPi / 2, kPi / 2}, {}, Order::Second);
  const MeshResult result = try_mesh(sphere, options).value();
  EXPECT_TRUE(result.report.reached_limit);
  EXPECT_EQ(result.report.undefined_fraction, 0);
  // All triangles are for the best tolerance that they allow, from the start.
  const double best = 0.385 * 4 * kPi / 40'000;
  EXPECT_LT(result.report.max_error, 3.5 * best);
  EXPECT_GT(result.report.max_error, best);
  // Six for each triangle, four for its search, and a few for proofs.
  EXPECT_LT(result.report.evaluations, 14 * result.mesh.triangles.size());
}

TEST(BoundedWork, DoesNotFollowTheRimsOfWavesThatNoMeshCouldFollow) {
  MeshRequest options = within_share(1e-2, 3);
  options.max_triangles = 160'000;
  const MeshResult result = try_mesh(height_field("sqrt(sin(1e3*u*v))"), options).value();
  EXPECT_FALSE(result.report.reached_limit);
  EXPECT_TRUE(result.report.oscillates);
  EXPECT_FALSE(result.mesh.triangles.empty());
}

TEST(BoundedWork, FollowsWavesBesideThoseThatItCannot) {
  // Up to u = 0.05 waves are as long as some ten cells of four tolerances.
  const MeshResult result = try_mesh(height_field("sin(exp(20*u)*v)"), thousandth()).value();
  double gap = 0;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& p = result.mesh.position;
    const dvec3 middle = (p[a] + p[b] + p[c]) / 3.0;
    if (middle.x > 0.05) continue;
    const double rate = std::exp(20 * middle.x);
    const double slope = std::cos(rate * middle.y) * rate * std::hypot(20 * middle.y, 1);
    gap = std::max(gap, std::fabs(middle.z - std::sin(rate * middle.y)) / std::hypot(1, slope));
  }
  EXPECT_LT(gap, 1.1 * *result.report.tolerance);  // a straight line up to the surface is longer
}

TEST(BoundedWork, FillsWhatWavesSweepThatItCannotFollow) {
  const Mesh mesh = try_mesh(height_field("sin(1e6*u)"), thousandth()).value().mesh;
  constexpr std::size_t kStrips = 50;
  std::array<Bounds, kStrips> strips;
  for (const dvec3& p : mesh.position) {
    EXPECT_NEAR(p.z, std::sin(1e6 * p.x), 1e-9);
    const auto strip = static_cast<std::size_t>((p.x + 1) / 2 * kStrips);
    strips[std::min(strip, kStrips - 1)].add(p);
  }
  for (const Bounds& strip : strips) {
    EXPECT_GT(strip.high.z, 0.99);
    EXPECT_LT(strip.low.z, -0.99);
  }
  // Its edges are where they were, and no triangle is turned over.
  EXPECT_EQ(mesh.bounds.low.x, -1);
  EXPECT_EQ(mesh.bounds.high.x, 1);
  EXPECT_EQ(mesh.bounds.low.y, -1);
  EXPECT_EQ(mesh.bounds.high.y, 1);
  std::size_t turned = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const dvec2 along = mesh.uv[b] - mesh.uv[a];
    const dvec2 across = mesh.uv[c] - mesh.uv[a];
    if (!(along.x * across.y - along.y * across.x > 0)) ++turned;
  }
  EXPECT_EQ(turned, 0U) << mesh.triangles.size();
}

TEST(BoundedWork, TakesRangesOfFewDoubles) {
  // Samples in them are rounded, some of them to the end.
  for (const Domain& domain :
       {Domain{1, 1 + 2e-14, -1, 1}, Domain{1e16, 1e16 + 2, 0, 1}, Domain{0, 1, 1 + 1.1e-15, 1}}) {
    const Surface sheet = surface_from_text("u", "v*1e16", "u+1e16*v^2", domain, {}, Order::Second);
    const std::optional<MeshResult> result = try_mesh(sheet, within_share(3e-3, 3));
    if (result) {
      EXPECT_FALSE(result->mesh.triangles.empty());
    }
  }
}

TEST(BoundedWork, SaysThatTheLimitWasReachedWhereOnlyCutCellsAreLeft) {
  MeshRequest options = thousandth();
  options.max_triangles = 1000;
  const MeshResult result = try_mesh(height_field("sign(sin(9*u)+sin(7*v))"), options).value();
  EXPECT_GT(result.report.max_error, *result.report.tolerance);
  EXPECT_TRUE(result.report.reached_limit);
}

TEST(BoundedWork, DoesNotTakeFrontsAndPeaksForWaves) {
  for (const char* z :
       {"tanh(1e3*(u+0.3*v))", "exp(-1e7*((u-0.123)^2+(v+0.321)^2))", "tanh(1e4*u)*tanh(1e4*v)",
        "floor(3*u)+floor(3*v)", "sin(60*u*v)", "sqrt(abs(u*v))"}) {
    const MeshResult result = try_mesh(height_field(z), thousandth()).value();
    EXPECT_FALSE(result.report.oscillates) << z;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << z;
  }
}

TEST(BoundedWork, CountsTheSearchForCutsAsTriangles) {
  const Surface poles =
      surface_from_text("tan(u)", "tan(v)", "tan(u*v)", {-10, 10, -10, 10}, {}, Order::Second);
  MeshRequest options = thousandth();
  options.max_triangles = 40'000;
  options.clip = Bounds{dvec3(-30), dvec3(30)};
  const MeshResult result = try_mesh(poles, options).value();
  EXPECT_TRUE(result.report.reached_limit);
  EXPECT_LT(result.mesh.triangles.size(), 40'000U);
  // Two for each place of the least effort: most are looks along sides, at a point or a box each.
  EXPECT_LT(result.report.evaluations, 2 * kLeastEffort + kLeastEffort / 4);
  EXPECT_TRUE(result.report.worst_place);
}

TEST(BoundedWork, EndsTheSearchForJumpsWithoutEnd) {
  constexpr std::size_t kTriangles = 100'000;  // more than there are before it is tired
  for (const char* z : {"mod(1e4*u*v,1)", "floor(1/u)+floor(1/v)"}) {
    MeshRequest options = thousandth();
    options.max_triangles = kTriangles;
    options.clip = Bounds{dvec3(-5), dvec3(5)};
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_TRUE(result.report.reached_limit) << z;
    EXPECT_TRUE(result.report.budget_spent) << z;
    EXPECT_FALSE(result.report.certified) << z;
    EXPECT_TRUE(result.report.worst_place) << z;
    // What is begun is ended: the sides that are looked at together, and what those are that are
    // cut.
    EXPECT_LT(result.report.effort, 4 * most_effort(kTriangles)) << z;
  }
  // As many as there are, and not without end.
  const MeshResult steps = try_mesh(height_field("floor(9*u)*floor(9*v)"), thousandth()).value();
  EXPECT_FALSE(steps.report.budget_spent);
  EXPECT_LE(steps.report.max_error, *steps.report.tolerance);
}

TEST(BoundedWork, CountsLooksByWhatTheyTake) {
  // Bounds of ln|gamma| take as long as some ten products.
  Effort plain(height_field("u*v"));
  Effort dear(height_field("lgamma(u*v)"));
  for (Effort* const effort : {&plain, &dear}) effort->looks() += 1'000'000;
  EXPECT_GT(dear.total(), 3 * plain.total());
  // What leaves take counts the same.
  Effort leaves(height_field("u*v"));
  leaves.add_places(1'000'000);
  EXPECT_GT(leaves.total(), plain.total());
}

TEST(BoundedWork, CountsPlacesByWhatTheirFormulaTakes) {
  EXPECT_LT(Effort(height_field("u*v")).place(), 1.1);
  EXPECT_GT(Effort(height_field("sum(sin(n*u*v), n=1:100)")).place(), 3);
}

TEST(BoundedWork, SearchesOneOfManySurfacesLess) {
  const auto mesh_with = [](std::size_t least_effort) {
    MeshRequest request = thousandth();
    request.max_triangles = 1'250;
    request.least_effort = least_effort;
    return try_mesh(height_field("sin(9*u*v)"), request).value().report;
  };
  const MeshReport alone = mesh_with(kLeastEffort);
  const MeshReport one_of_many = mesh_with(kLeastEffort / 100);
  EXPECT_LT(5 * one_of_many.evaluations, 4 * alone.evaluations);
  EXPECT_GT(one_of_many.max_error, 0.5 * alone.max_error) << "the error is still told";
}

TEST(BoundedWork, EndsWhereThePointsOfASurfaceAreUsedUp) {
  const Surface surface = height_field("sin(1/(u*v))");
  const auto evaluations = [&surface](std::size_t points) {
    surface.tangents.count->allow(points);
    const MeshResult result = try_mesh(surface, thousandth()).value();
    EXPECT_TRUE(result.report.reached_limit);
    EXPECT_TRUE(result.report.budget_spent);
    EXPECT_GT(result.mesh.triangles.size(), 500U);
    EXPECT_GT(result.report.max_error, *result.report.tolerance);
    return result.report.evaluations;
  };
  // What has begun ends: samples before there is a mesh, and a generation of leaves.
  EXPECT_LT(evaluations(60'000), 500'000U);
  EXPECT_GT(evaluations(1'200'000), 1'200'000U);
}

TEST(BoundedWork, EndsWhateverLeavesTake) {
  constexpr std::size_t kTriangles = 150'000;
  for (const char* z : {"sin(200*u*v)", "lgamma(9*u*v)", "sqrt(sin(60*u)*sin(60*v))",
                        "max(sin(90*u),cos(110*v),sin(130*u*v))"}) {
    MeshRequest options = thousandth();
    options.max_triangles = kTriangles;
    const MeshResult result = try_mesh(height_field(z), options).value();
    EXPECT_TRUE(result.report.reached_limit) << z;
    EXPECT_TRUE(result.report.worst_place) << z;
    // Leaves are measured when the last of them have been halved, those that are cut on many
    // places.
    EXPECT_LT(result.report.effort, 3 * most_effort(kTriangles)) << z;
  }
}

TEST(BoundedWork, PlacesNoMoreLinesThanShowHoweverFastWavesAre) {
  for (const char* z : {"sin(1e6*u)", "sin(1e15*u)"}) {
    const std::optional<MeshPlan> plan = plan_mesh(height_field(z), thousandth());
    ASSERT_TRUE(plan) << z;
    EXPECT_LT(plan->lines.u.size(), 1000U) << z;
  }
}

TEST(BoundedWork, StopsAtPolesIfNoMoreIsAskedFor) {
  const Surface poles = height_field("ln(abs(u^2+v^2-0.5))");
  MeshRequest options = within_share(3e-3);
  const MeshResult whole = try_mesh(poles, options).value();
  options.stop = MeshRequest::Stop::AtPolesOrFar;
  options.far = 1e9;
  const MeshResult known = try_mesh(poles, options).value();
  EXPECT_TRUE(known.mesh.triangles.empty());
  ASSERT_GT(known.report.pole_count, 0U);
  EXPECT_LT(10 * known.report.evaluations, whole.report.evaluations);
  for (const dvec2& pole : known.report.poles) EXPECT_NEAR(glm::dot(pole, pole), 0.5, 1e-12);
  EXPECT_LT(known.report.beside_poles.low.z, -30);  // ln(1e-16) = -37
  // The surface goes nowhere else.
  const MeshResult smooth = try_mesh(height_field("u*v"), options).value();
  EXPECT_FALSE(smooth.mesh.triangles.empty());
}

TEST(BoundedWork, StopsAtWhatIsTooFarAwayIfNoMoreIsAskedFor) {
  // tan(pi/2) is 1.6e16 in doubles: whole sides of the domain are that far away, where every leaf
  // is too large.
  const Surface funnel = surface_from_text("tan(u)*cos(v)", "tan(u)*sin(v)", "tan(v)",
                                           {-kPi / 2, kPi / 2, 0, kPi / 2}, {}, Order::Second);
  MeshRequest options = thousandth();
  options.stop = MeshRequest::Stop::AtPolesOrFar;
  options.far = 1000;
  const MeshResult mesh = try_mesh(funnel, options).value();
  EXPECT_TRUE(mesh.mesh.triangles.empty());
  EXPECT_LT(mesh.report.evaluations, 50'000U);
  EXPECT_GT(mesh.report.beside_poles.high.x, 1e15);
  EXPECT_GT(mesh.report.beside_poles.high.z, 1e15);
  EXPECT_FALSE(try_mesh(height_field("u*v"), options)->mesh.triangles.empty());
}

TEST(BoundedWork, EndsWhereASurfaceOscillatesFasterThanAnyPictureShows) {
  const MeshResult result = try_mesh(height_field("sin(1/u)"), within_share(1e-3)).value();
  EXPECT_FALSE(result.report.reached_limit);
  EXPECT_LT(result.mesh.triangles.size(), 200'000U);
  EXPECT_GT(result.report.max_error, *result.report.tolerance);  // and says so
  double gap = 0;  // where the waves are wide the mesh is as near as anywhere
  for (const Triangle& t : result.mesh.triangles) {
    const dvec3 middle =
        (result.mesh.position[t[0]] + result.mesh.position[t[1]] + result.mesh.position[t[2]]) /
        3.0;
    if (std::fabs(middle.x) < 0.1) continue;
    const double slope = std::cos(1 / middle.x) / (middle.x * middle.x);
    gap = std::max(gap, std::fabs(middle.z - std::sin(1 / middle.x)) / std::hypot(1, slope));
  }
  EXPECT_LT(gap, 1.1 * *result.report.tolerance);  // a straight line up to the surface is longer
}

TEST(BoundedWork, EndsWhereALineHasAnyNumberOfThinParts) {
  // Beside u=0 poles and overflows take turns; each half of a side has as many.
  MeshRequest options = within_share(3e-3);
  options.clip = Bounds{{-1, -1, -3}, {1, 1, 5}};
  const MeshResult result = try_mesh(height_field("gamma(1/u)"), options).value();
  EXPECT_LT(result.report.evaluations, 50'000'000U);
  EXPECT_FALSE(result.mesh.triangles.empty());
}

TEST(BoundedWork, DoesNotCutLeavesIntoSliversAcrossAJumpBetweenPoints) {
  // Beside u=-v each sheet has one point as its edge there: its leaves are too coarse along v.
  const Surface surface = surface_from_text("exp(1/(5*v))", "atan2(u+v,v)", "(u+v)/sin(u)",
                                            {-1, 1, -1, 1}, {}, Order::Second);
  MeshRequest options = within_length(0.01354);
  options.normal_tolerance = 3;
  options.clip = Bounds{{-2.1, -3.2, -4.0}, {6.7, 3.2, 6.0}};
  const MeshResult result = try_mesh(surface, options).value();
  EXPECT_FALSE(result.report.reached_limit);
  EXPECT_LT(result.report.evaluations, 5'000'000U);
}

TEST(BoundedWork, EndsBesideChordsOfTrianglesLongerThanAllLengths) {
  const Surface surface =
      surface_from_text("(u^2-v)/(u-v)/(floor(2*(u^2+v^2-1))+0.5)", "exp(1/(u-v))", "1/u/sin(u)^2",
                        {-3, 3, -3, 3}, {}, Order::Second);
  MeshRequest options = thousandth();
  options.clip = Bounds{{-1, -5, -10}, {2, 5, 3}};
  EXPECT_FALSE(try_mesh(surface, options)->mesh.triangles.empty());
}

}  // namespace
}  // namespace saddle
