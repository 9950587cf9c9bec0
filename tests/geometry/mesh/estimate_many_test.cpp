// Leaves judged and measured many at a time come out as they would one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "mesh/error/error_loops.h"
#include "mesh/error/estimate_many.h"
#include "mesh/error/validate_many.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/halve.h"
#include "mesh/tree/singular_corners.h"
#include "surface/parameter_box.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

Surface waves() {
  return surface_from_text("u+v^2/9", "v", "sin(3*u)*cos(2*v)+u^3/9", {-2, 3, -2, 2}, {},
                           Order::Second);
}

/// Smooth, but for what is along u = 0.1: a fold.
Surface folded() {
  return surface_from_text("abs(u-0.1)", "v", "u^2+v^2", {-1, 1, -1, 1}, {}, Order::Second);
}

/// Narrow ridges along a ribbon. Lines of the parameters run nearly along them, and cells are thin.
Surface ridges() {
  return surface_from_text("u+v", "0.03*(u-v)", "0.002*sin(15*(u-v))", {-2, 3, -2, 2}, {},
                           Order::Second);
}

/// A lattice on 20 x 17 cells, or a multiple of that each way, with all samples of its root leaves.
struct Subject {
  explicit Subject(const Surface& s, const CellLimits& cell_limits, std::size_t multiple = 1)
      : surface(s), limits(cell_limits), fine(multiple) {
    tree.geometry().add_middles(1);
    for (Leaf& leaf : leaves) request_samples(leaf, tree);
  }

  const Surface& surface;
  CellLimits limits;
  std::size_t fine;
  Grid grid = sample_grid(surface, even_lines(surface.domain.u0, surface.domain.u1, 20 * fine),
                          even_lines(surface.domain.v0, surface.domain.v1, 17 * fine), 1);
  CellTree tree{surface, grid, 1};
  ErrorIndicator indicator{limits, grid, tree};
  std::vector<Leaf> leaves = root_leaves(grid, 0, grid.cell_count());
};

CellLimits limits_for(double tolerance, double degrees) {
  CellLimits limits{tolerance, degrees, {1000}, {}, {}, {}, 1};
  limits.seen_u.assign(21, 0);
  limits.seen_v.assign(18, 0);
  limits.seen_u[4] = limits.seen_v[0] = 1;
  return limits;
}

FastCellErrors glances_at(const Subject& subject) {
  return estimate_many(subject.leaves, subject.limits, subject.indicator, subject.tree);
}

std::size_t count_known(const FastCellErrors& fast_errors) {
  return static_cast<std::size_t>(
      std::ranges::count_if(fast_errors.leaves, &FastCellError::is_known));
}

void expect_near(const ErrorRatios& a, const ErrorRatios& b, std::size_t leaf) {
  for (const auto part : {&ErrorRatios::along_u, &ErrorRatios::along_v, &ErrorRatios::centre}) {
    EXPECT_NEAR(a.*part, b.*part, 1e-9 * std::max(1.0, b.*part)) << leaf;
  }
}

TEST(ManyLeaves, AreJudgedAsOneByOne) {
  for (const double safety : {1.0, 1.5}) {
    const Surface surface = waves();
    Subject subject(surface, limits_for(0.02, 9));
    for (Leaf& leaf : subject.leaves) {
      leaf.safety = static_cast<float>(safety);
      leaf.normal_safety = static_cast<float>(2 * safety);
    }
    const FastCellErrors fast_errors = glances_at(subject);
    std::size_t good = 0;
    std::size_t unknown = 0;
    for (std::size_t k = 0; k < fast_errors.leaves.size(); ++k) {
      const CellError error = subject.indicator.estimate(subject.leaves[k]);
      const bool passes = safety * std::max(error.distance.worst(), 2 * error.turn.worst()) <= 1;
      if (!fast_errors.leaves[k].is_known) {
        EXPECT_FALSE(passes) << k;
        ++unknown;
        continue;
      }
      EXPECT_EQ(fast_errors.leaves[k].passes, passes) << k;
      if (passes) {
        EXPECT_NEAR(fast_errors.leaves[k].distance, error.distance.worst(), 1e-6) << k;
        ++good;
        continue;
      }
      expect_near(fast_errors.error(fast_errors.leaves[k])->distance, error.distance, k);
      expect_near(fast_errors.error(fast_errors.leaves[k])->gap, error.gap, k);
      expect_near(fast_errors.error(fast_errors.leaves[k])->turn, error.turn, k);
    }
    EXPECT_GT(good, fast_errors.leaves.size() / 10);
    EXPECT_LT(good, fast_errors.leaves.size() * 9 / 10);
    EXPECT_LT(unknown, fast_errors.leaves.size() / 50);  // bent too much
  }
}

TEST(ManyLeaves, ThatFailLeaveClippingAndLimitsToACloserLook) {
  const Surface surface = waves();
  const Subject whole(surface, limits_for(0.02, 9));
  CellLimits clipped = whole.limits;
  clipped.clip = Bounds{dvec3(-9), dvec3(9)};
  const std::vector<FastCellError> of_whole = glances_at(whole).leaves;
  const std::vector<FastCellError> of_clipped = glances_at(Subject(surface, clipped)).leaves;
  for (std::size_t k = 0; k < of_whole.size(); ++k) {
    EXPECT_EQ(of_clipped[k].passes, of_whole[k].passes);
    EXPECT_EQ(of_clipped[k].is_known, of_whole[k].passes);
  }
  // On the cone's tip is no normal but the one that each leaf sees.
  const Surface cone =
      surface_from_text("v*cos(u)", "v*sin(u)", "v", {0, 6, 0, 1}, {}, Order::Second);
  const std::vector<FastCellError> of_cone = glances_at(Subject(cone, limits_for(1e-4, 9))).leaves;
  for (std::size_t k = 0; k < of_cone.size(); ++k) EXPECT_EQ(of_cone[k].is_known, k >= 20) << k;
}

TEST(ManyLeaves, AreJudgedAlikeOnEveryNumberOfThreads) {
  for (const Surface& surface : {waves(), folded()}) {
    std::vector<FastCellErrors> judged;
    for (const unsigned threads : {1u, 3u}) {
      CellLimits limits{0.02, 9, {5000}, {}, {}, {}, threads};
      limits.seen_u.assign(41, 0);
      limits.seen_v.assign(35, 0);
      const Subject subject(surface, limits, 2);  // in three chunks
      judged.push_back(glances_at(subject));
      estimate_others(subject.leaves, subject.limits, subject.indicator, subject.tree,
                      judged.back());
      for (std::size_t k = 0; k < subject.leaves.size(); ++k) {
        const CellError* const error = judged.back().error(judged.back().leaves[k]);
        if (error != nullptr)
          expect_near(error->distance, subject.indicator.estimate(subject.leaves[k]).distance, k);
      }
    }
    EXPECT_GT(judged[0].errors.size(), judged[0].leaves.size() / 50);
    EXPECT_EQ(judged[0].errors.size(), judged[1].errors.size());
    EXPECT_EQ(count_known(judged[0]), judged[0].leaves.size());
    EXPECT_EQ(count_known(judged[1]), judged[1].leaves.size());
  }
}

TEST(ManyLeaves, CountHowNormalsTurnAcrossSliversOnlyIfItIsSeen) {
  const Surface surface = ridges();
  constexpr double kThickness = 0.014;  // of all cells
  for (const double seen : {0.9 * kThickness, 1.2 * kThickness}) {
    const Subject subject(surface, limits_for(seen / kSeenTurn, 3));
    const FastCellErrors fast_errors = glances_at(subject);
    for (std::size_t k = 0; k < fast_errors.leaves.size(); ++k) {
      const CellError error = subject.indicator.estimate(subject.leaves[k]);
      ASSERT_LT(error.distance.worst(), 0.5);
      if (seen < kThickness) {
        ASSERT_GT(error.turn.worst(), 1);
        ASSERT_FALSE(fast_errors.leaves[k].passes);
        expect_near(fast_errors.error(fast_errors.leaves[k])->turn, error.turn, k);
      } else {
        ASSERT_EQ(error.turn.worst(), 0);
        ASSERT_TRUE(fast_errors.leaves[k].passes);
      }
    }
  }
}

TEST(ManyLeaves, LeaveFoldsToACloserLook) {
  const Surface surface = folded();
  Subject subject(surface, limits_for(0.5, 180));
  const FastCellErrors fast_errors = glances_at(subject);
  for (std::size_t k = 0; k < fast_errors.leaves.size(); ++k) {
    // The line u = 0.1 is that of the grid: the two columns beside it touch it.
    const std::size_t column = k % 20;
    if (column != 10 && column != 11) {
      ASSERT_TRUE(fast_errors.leaves[k].is_known) << column;
    }
  }
  subject.leaves[0].state.set_features(true, false);
  subject.leaves[1].state.set_features(false, true);
  EXPECT_EQ(count_known(glances_at(subject)), count_known(fast_errors) - 2);
}

TEST(ManyLeaves, LeaveWhatIsUndefinedToACloserLook) {
  const Surface surface = height_field("sqrt(u)");
  Subject subject(surface, limits_for(10, 180));
  const FastCellErrors fast_errors = glances_at(subject);
  for (std::size_t k = 0; k < fast_errors.leaves.size(); ++k) {
    if (k % 20 < 11) {
      ASSERT_FALSE(fast_errors.leaves[k].is_known) << k;
    }
  }
  EXPECT_GT(count_known(fast_errors), 17 * 7U);
}

TEST(ManyLeaves, AreMeasuredAsOneByOne) {
  for (const bool flip : {false, true}) {
    Surface surface = waves();
    surface.flip = flip;
    Subject subject(surface, limits_for(1, 180), 4);
    std::vector<std::size_t> all(subject.leaves.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = k;
    const LeafTriangles triangles =
        triangulate_leaves(subject.leaves, all, SingularCorners(), subject.grid, subject.tree, 1);
    // Beside the diagonals: on the same triangle as the point below them.
    const PlacesInLeaf places = {dvec2(0.15, 0.35), dvec2(0.85, 0.35), dvec2(0.35, 0.85),
                                 dvec2(0.65, 0.15)};
    std::vector<TwoTriangles> leaves;
    for (const std::size_t k : all) {
      ASSERT_TRUE(triangles.ranges[k].is_plain);
      leaves.push_back({subject.tree.vertices().parameters(subject.leaves[k].low),
                        subject.tree.vertices().parameters(subject.leaves[k].high()),
                        {triangles.of(k)[0], triangles.of(k)[1]},
                        places});
    }
    const auto measured = validate_many(surface, subject.grid, leaves, 1);
    for (const std::size_t k : all) {
      SampledError worst;
      for (const dvec2& part : places) {
        const dvec2 uv = leaves[k].low * (1.0 - part) + leaves[k].high * part;
        const SurfacePoint point = evaluate(surface, std::array{uv})[0];
        const SampledError d = sampled_error(subject.grid, triangles.of(k), uv, point, flip);
        worst.distance = std::max(worst.distance, d.distance);
        worst.degrees = std::max(worst.degrees, d.degrees);
      }
      ASSERT_TRUE(measured[k]) << k;
      ASSERT_NEAR(measured[k]->worst.distance, worst.distance, 1e-9 * worst.distance) << k;
      ASSERT_NEAR(measured[k]->worst.degrees, worst.degrees, 1e-6 * worst.degrees) << k;
    }
  }
}

TEST(ManyLeaves, AreNotMeasuredWhereTheSurfaceIsUndefinedOrSingular) {
  const Surface surface =
      surface_from_text("u^3", "v^3", "u+v+0*sqrt(u)", {0, 1, 0, 1}, {}, Order::Second);
  Subject subject(surface, limits_for(1, 180));
  TwoTriangles leaf{{0.5, 0.5}, {0.55, 0.6}, {}, {}};
  leaf.triangles = {Triangle{0, 1, 22}, Triangle{22, 21, 0}};
  leaf.places = {dvec2(0.3, 0.2), dvec2(0.3, 0.2), dvec2(0.3, 0.2), dvec2(-50, 0.2)};
  EXPECT_FALSE(validate_many(surface, subject.grid, std::span(&leaf, 1), 1)[0]);
}

TEST(ManyLeaves, PlacesOnTheirTrianglesAreMeasuredAsOneByOne) {
  const Surface surface = waves();
  Subject subject(surface, limits_for(1, 180), 4);
  const std::vector<std::size_t> which = {5, 700};
  const LeafTriangles triangles =
      triangulate_leaves(subject.leaves, which, SingularCorners(), subject.grid, subject.tree, 1);
  for (std::size_t k = 0; k < which.size(); ++k) {
    // On the first triangle, a b c, across its side from c to a from the second.
    const Triangle& t = triangles.of(k)[0];
    const Triangle& other = triangles.of(k)[1];
    const auto is_shared = [&](std::uint32_t corner) { return std::ranges::count(other, corner); };
    const auto b = static_cast<std::size_t>(std::ranges::find_if_not(t, is_shared) - t.begin());
    const Triangle own = {t[(b + 2) % 3], t[b], t[(b + 1) % 3]};
    const std::uint32_t beyond = *std::ranges::find_if_not(
        other, [&](std::uint32_t corner) { return std::ranges::count(own, corner) > 0; });
    for (const dvec3& weights :
         {dvec3(1.0 / 3), dvec3(0.5, 0, 0.5), dvec3(0.2, 0.7, 0.1), dvec3(0.4, -0.1, 0.7)}) {
      dvec2 uv(0);
      for (std::size_t c = 0; c < 3; ++c) {
        uv += weights[static_cast<int>(c)] * subject.grid.mesh.uv[own[c]];
      }
      const PlaceOnTriangle place{uv, {own[2], beyond, own[0], own[1]}, weights};
      const auto measured = validate_places(surface, subject.grid, std::span(&place, 1), 1)[0];
      const SurfacePoint point = evaluate(surface, std::array{uv})[0];
      const auto of = weights.y < 0 ? triangles.of(k).subspan(1) : triangles.of(k);
      const SampledError d = sampled_error(subject.grid, of, uv, point, false);
      ASSERT_TRUE(measured);
      // Outside of its triangle a place has no height, but a distance from the other one.
      if (weights.y < 0) {
        EXPECT_LE(measured->worst.distance, d.distance * (1 + 1e-9));
        EXPECT_GT(measured->worst.distance, 0);
        continue;
      }
      EXPECT_NEAR(measured->worst.distance, d.distance, 1e-9 * d.distance);
      // On the side the point straight below may be on either triangle.
      if (weights.y == 0) continue;
      EXPECT_NEAR(measured->worst.degrees, d.degrees, 1e-6 * d.degrees);
    }
  }
}

/// A bowl over a square of some size.
double bowl(double x, double y) {
  return 0.3 * x * x + 0.2 * x * y - 0.1 * y * y * y;
}
void put_bowl(double x, double y, std::size_t i, LeafVertices& to) {
  const dvec3 normal =
      glm::normalize(dvec3(-0.6 * x - 0.2 * y, -0.2 * x + 0.3 * y * y, i % 7 == 3 ? -1 : 1));
  to.x[i] = x;
  to.y[i] = y;
  to.z[i] = bowl(x, y);
  to.n_x[i] = normal.x;
  to.n_y[i] = normal.y;
  to.n_z[i] = normal.z;
}

TEST(ManyLeaves, AreJudgedAlikeOnEveryCpuLevel) {
  auto leaves = std::make_unique<LeafSamples>();
  for (std::size_t i = 0; i < kLeafBlock; ++i) {
    const double x = 0.02 * static_cast<double>(i);
    const double h = 0.01 + 0.003 * static_cast<double>(i);
    const std::array<dvec2, 4> ends = {dvec2(x, 0), dvec2(x + h, 0), dvec2(x + h, h), dvec2(x, h)};
    for (std::size_t k = 0; k < 4; ++k) {
      const dvec2 middle = 0.5 * (ends[k] + ends[(k + 1) % 4]);
      put_bowl(ends[k].x, ends[k].y, i, leaves->corner[k]);
      put_bowl(middle.x, middle.y, i, leaves->side[k]);
      leaves->counts[k][i] = i % 5 == k ? 0 : 1;
      leaves->seen[k][i] = i % 3 == k ? 1 : 0;
    }
    put_bowl(x + 0.5 * h, 0.5 * h, i, leaves->centre);
    if (i % 5 == 2) leaves->centre.n_z[i] *= -1;
    leaves->seen_turn[i] = 0.02;
  }
  auto lowest = std::make_unique<LeafErrors>();
  auto errors = std::make_unique<LeafErrors>();
  estimate_loop(CpuLevel::Sse2)(*leaves, kLeafBlock, *lowest);
  EXPECT_GT(std::ranges::count(lowest->is_plain, 1.0), 20);
  EXPECT_GT(std::ranges::count(lowest->is_plain, 0.0), 10);
  for (std::size_t level = 1; level < supported_level_count(); ++level) {
    estimate_loop(static_cast<CpuLevel>(level))(*leaves, kLeafBlock, *errors);
    EXPECT_EQ(errors->is_plain, lowest->is_plain);
    for (const auto of : {&LeafErrors::distance, &LeafErrors::square_of_tangent}) {
      EXPECT_EQ((*errors.*of).along_u, (*lowest.*of).along_u);
      EXPECT_EQ((*errors.*of).along_v, (*lowest.*of).along_v);
      EXPECT_EQ((*errors.*of).centre, (*lowest.*of).centre);
    }
  }
}

TEST(ManyLeaves, AreMeasuredAlikeOnEveryCpuLevel) {
  auto leaves = std::make_unique<LeafPoints>();
  leaves->scale = 0.5;
  leaves->front = -1;
  LeafNumbers p, q;
  std::array<LeafNumbers, 9> columns;
  for (std::size_t i = 0; i < kLeafBlock; ++i) {
    const double x = 0.02 * static_cast<double>(i);
    constexpr double kSide = 0.1;
    put_bowl(x, 0, i, leaves->corner[0]);
    put_bowl(x + kSide, 0, i, leaves->corner[1]);
    put_bowl(x + kSide, kSide, i, leaves->corner[2]);
    put_bowl(x, kSide, i, leaves->corner[3]);
    p[i] = 0.007 * static_cast<double>(i);
    q[i] = 0.4;
    const dvec2 at(x + kSide * p[i], kSide * q[i]);
    const std::array<double, 9> row = {at.x, at.y, bowl(at.x, at.y),
                                       1,    0,    0.6 * at.x + 0.2 * at.y,
                                       0,    1,    0.2 * at.x - 0.3 * at.y * at.y};
    for (std::size_t k = 0; k < 9; ++k) columns[k][i] = (k < 3 ? 2 : 1) * row[k];
  }
  LeafPlaces places{p.data(), q.data(), {}};
  for (std::size_t k = 0; k < 9; ++k) places.surface[k] = columns[k].data();
  const auto measure = [&](CpuLevel level) {
    auto result = std::make_unique<LeafSampledErrors>();
    result->distance.fill(0);
    result->predicted.fill(0);
    result->chord.fill(0);
    result->is_known.fill(1);
    validate_loop(level)(*leaves, places, kLeafBlock, *result);
    return result;
  };
  const auto lowest = measure(CpuLevel::Sse2);
  EXPECT_GT(std::ranges::count(lowest->is_known, 1.0), 100);
  for (std::size_t level = 1; level < supported_level_count(); ++level) {
    const auto result = measure(static_cast<CpuLevel>(level));
    EXPECT_EQ(result->distance, lowest->distance);
    EXPECT_EQ(result->predicted, lowest->predicted);
    EXPECT_EQ(result->chord, lowest->chord);
    EXPECT_EQ(result->is_known, lowest->is_known);
  }
}

}  // namespace
}  // namespace saddle
