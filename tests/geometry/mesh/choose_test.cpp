// Which method meshes a surface: over the gallery the cheapest of those that keep the tolerance, or
// nearly so, in counted costs.
#include "mesh/mesher/choose.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "base/random.h"
#include "geometry/gallery/samples.h"
#include "mesh/mesher/grid_within.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/triangle_tree.h"
#include "mesh/sizing/cost_model.h"
#include "mesh/sizing/grid_sizing.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "meshing/tolerance.h"
#include "scene/options/resolve.h"
#include "study/mesh_distance.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

using Why = MeshChoice::Why;

/// The choice costs at most so many times what the best method does.
constexpr double kOfBest = 1.5;
/// The smallest cells of a grid that is thought of as a method are smaller by this factor and its
/// square: nobody knows before which is the coarsest that keeps the tolerance.
constexpr double kFiner = 1.3;
constexpr int kFinest = 3;

/// A surface of the gallery in the program's usual picture.
class InGallery {
 public:
  explicit InGallery(const std::string& name)
      : scene_(resolve(scene_of(name))),
        subject_(scene_, scene_.surfaces.at(0)),
        operations_(count_operations(subject_.surface)) {
    subject_.clip = options_.clip = scene_.clip.box;
    options_.tolerance = [this](const Probe& probe) {
      return tolerance_of(scene_, subject_.spec, {.picture = true}, probe, options_.clip);
    };
    options_.normal_tolerance = scene_.mesh.normal_tolerance;
  }

  std::optional<MeshResult> choose(double times = 1) const {
    MeshRequest request = options_;
    request.method = MeshRequest::Method::LeastCost;
    request.draws = times;
    return try_mesh(subject_.surface, request);
  }
  std::optional<MeshResult> halve() const { return try_mesh(subject_.surface, options_); }

  /// The cheapest of some grids that keep the tolerance.
  std::optional<MeshResult> best_grid() const {
    const auto plan = plan_mesh(subject_.surface, options_);
    if (!plan || options_.clip || !plan->tolerance.is_same_everywhere()) return std::nullopt;
    double scale = 1;
    for (int k = 0; k < kFinest; ++k, scale /= kFiner) {
      const FixedLines lines =
          place_lines(plan->probe, plan->fixed, plan->sizing, 1 / std::sqrt(scale));
      GridTrial trial = try_grid(subject_.surface, options_, *plan, lines);
      if (trial.mesh) return std::move(trial.mesh);
      if (trial.excess == 0) break;
    }
    return std::nullopt;
  }

  double cost_of(const MeshResult& mesh) const {
    return cost(mesh.report.work, operations_) +
           drawing_cost(static_cast<double>(mesh.mesh.triangles.size()), 1);
  }

  /// In 50 digits, both ways.
  double true_distance(const Mesh& mesh) const { return MeshDistance(subject_)(mesh); }

  /// The largest distance of points of the surface, at random, from the mesh's triangles.
  double sampled_distance(const Mesh& mesh) const {
    constexpr std::uint64_t kSamples = 3000;
    const Domain& d = subject_.surface.domain;
    std::vector<dvec2> uv;
    for (std::uint64_t k = 0; k < kSamples; ++k) {
      uv.emplace_back(std::lerp(d.u0, d.u1, random_unit(2 * k)),
                      std::lerp(d.v0, d.v1, random_unit(2 * k + 1)));
    }
    const TriangleTree tree(mesh);
    double largest = 0;
    for (const SurfacePoint& point : evaluate(subject_.surface, uv)) {
      largest = std::max(largest, tree.distance(point.position));
    }
    return largest;
  }

 private:
  Scene scene_;
  Subject subject_;
  Operations operations_;
  MeshRequest options_;
};

class ChoiceOverTheGallery : public testing::TestWithParam<std::string> {};

TEST_P(ChoiceOverTheGallery, IsNearlyTheCheapestAndKeepsTheTolerance) {
  const InGallery surface(GetParam());
  const std::optional<MeshResult> chosen = surface.choose();
  ASSERT_TRUE(chosen && chosen->report.choice);
  const bool is_grid = chosen->report.choice->why == Why::GridIsCheaper;
  double best = surface.cost_of(*chosen);
  if (const auto grid = surface.best_grid()) best = std::min(best, surface.cost_of(*grid));
  // Without a grid before it a mesh of halved cells is what it is.
  if (chosen->report.work.grid_samples > 0) {
    best = std::min(best, surface.cost_of(surface.halve().value()));
  }
  EXPECT_LE(surface.cost_of(*chosen), kOfBest * best);
  if (!is_grid) return;
  const double tolerance = chosen->report.tolerance.value();
  EXPECT_LE(chosen->report.max_error, tolerance);
  EXPECT_LE(chosen->report.max_normal_error, 3);
  EXPECT_LE(surface.sampled_distance(chosen->mesh), tolerance);
  EXPECT_EQ(triangles_against_normals(chosen->mesh), 0U);
}

// A few of them in 50 digits, which takes a second each; ./dev efficiency measures more.
TEST(Choice, KeepsTheToleranceInFiftyDigits) {
  for (const char* const name : {"sphere", "mobius"}) {
    const InGallery surface(name);
    const MeshResult mesh = surface.choose().value();
    EXPECT_EQ(mesh.report.choice.value().why, Why::GridIsCheaper) << name;
    EXPECT_LE(surface.true_distance(mesh.mesh), mesh.report.tolerance.value()) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Gallery, ChoiceOverTheGallery, testing::ValuesIn([] {
                           std::vector<std::string> names;
                           for (const GalleryEntry& entry : gallery()) {
                             names.emplace_back(entry.name);
                           }
                           return names;
                         }()),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

MeshRequest half_a_thousandth() {
  return within_share(5e-4, 3);
}

MeshResult chosen(const Surface& surface, MeshRequest request = half_a_thousandth()) {
  request.method = MeshRequest::Method::LeastCost;
  return try_mesh(surface, request).value();
}

Why why(const MeshResult& mesh) {
  return mesh.report.choice.value().why;
}

TEST(Choice, TakesAGridWhereCurvatureIsMuchTheSameEverywhere) {
  const InGallery torus("torus");
  const MeshResult mesh = torus.choose().value();
  EXPECT_EQ(why(mesh), Why::GridIsCheaper);
  EXPECT_EQ(mesh.report.closed_u, "join");
  EXPECT_EQ(mesh.report.closed_v, "join");
  EXPECT_TRUE(mesh.report.certified);
  EXPECT_EQ(euler_number(mesh.mesh), 0);
  const MeshResult halved = torus.halve().value();
  EXPECT_EQ(mesh.mesh.lines.size(), halved.mesh.lines.size());
  EXPECT_LT(static_cast<double>(mesh.mesh.triangles.size()),
            1.2 * static_cast<double>(halved.mesh.triangles.size()));
}

TEST(Choice, MakesFansAtPolesAndMeetsReversedSeams) {
  const MeshResult sphere = InGallery("sphere").choose().value();
  EXPECT_EQ(why(sphere), Why::GridIsCheaper);
  EXPECT_EQ(euler_number(sphere.mesh), 2);
  EXPECT_EQ(triangles_against_normals(sphere.mesh), 0U);
  const MeshResult mobius = InGallery("mobius").choose().value();
  EXPECT_EQ(why(mobius), Why::GridIsCheaper);
  EXPECT_EQ(mobius.report.closed_u, "reversed");
  EXPECT_EQ(euler_number(mobius.mesh), 0);
}

TEST(Choice, HalvesCellsWhereAGridWouldWasteThem) {
  const MeshResult maximum = chosen(height_field("exp(-40*((u-0.3)^2+(v+0.2)^2))"));
  EXPECT_EQ(why(maximum), Why::HalvingIsCheaper);
  EXPECT_EQ(maximum.report.work.grid_samples, 0U);
}

TEST(Choice, HalvesCellsWhereASurfaceIsNotSmooth) {
  for (const char* const z : {"sqrt(u)", "1/(u+0.1)", "abs(u-0.1)", "floor(3*u)"}) {
    const MeshResult mesh = chosen(height_field(z));
    EXPECT_NE(why(mesh), Why::GridIsCheaper) << z;
    EXPECT_NE(why(mesh), Why::HalvingIsCheaper) << z;
  }
}

TEST(Choice, HalvesCellsWhereASheetIsTornApartWithinItsPlane) {
  // No point of a torn sheet is far from a triangle across the tear.
  for (const char* const x : {"u<0.03?u:u+1", "u+floor(2*v+0.1)", "u+sign(u-v)"}) {
    const Surface sheet = surface_from_text(x, "v", "0", {-1, 1, -1, 1}, {}, Order::Second);
    const MeshResult mesh = chosen(sheet);
    EXPECT_NE(why(mesh), Why::GridIsCheaper) << x;
    EXPECT_GT(mesh.report.jump_count, 0U) << x;
    for (const Triangle& t : mesh.mesh.triangles) {
      const auto& p = mesh.mesh.position;
      const dvec2 across = mesh.mesh.uv[t[1]] - mesh.mesh.uv[t[0]];
      ASSERT_LE(glm::distance(p[t[0]], p[t[1]]), 1.001 * glm::length(across)) << x;
    }
  }
}

TEST(Choice, GivesAGridUpThatMissesWhatNobodySawBefore) {
  // Narrower than the probe's cells, and than the grid's.
  const MeshResult spike = chosen(height_field("0.3*exp(-1e6*((u-0.123)^2+(v+0.321)^2))+u^2/9"));
  EXPECT_NE(why(spike), Why::GridIsCheaper);
  EXPECT_NEAR(spike.mesh.bounds.high.z, 0.3, 0.05);
  EXPECT_GT(spike.report.work.grid_samples, 0U);
}

TEST(Choice, IsMadeSoonWhereCloserLinesDoNotHelp) {
  // Flat but for a steep front: half of each column's samples, and so its lines, do not see it.
  const MeshResult plateau = chosen(height_field("tanh(1e5*(u^2+v^2-.5))/9"));
  EXPECT_NE(why(plateau), Why::GridIsCheaper);
  EXPECT_LE(plateau.report.choice.value().grids, 2U);
  // Where every closer grid has as many lines, those that are drawn.
  MeshRequest options = half_a_thousandth();
  options.lines_u = options.lines_v = 60;
  const MeshResult bump = chosen(height_field("exp(-40*(u^2+v^2))"), options);
  EXPECT_LE(bump.report.choice.value().grids, 8U);
}

TEST(Choice, HalvesCellsOfWhatIsClippedOrSeenFromCloseBy) {
  MeshRequest options = half_a_thousandth();
  options.clip = Bounds{dvec3(-2), dvec3(0.5)};
  EXPECT_EQ(why(chosen(height_field("u*v"), options)), Why::Limited);
  options = half_a_thousandth();
  options.tolerance = [](const Probe&) -> Tolerance {
    return [](const dvec3& p) { return 1e-3 * (1 + glm::length(p)); };
  };
  EXPECT_EQ(why(chosen(height_field("u*v"), options)), Why::VariesTolerance);
}

TEST(Choice, HalvesCellsRatherThanDrawMoreTrianglesManyTimes) {
  const InGallery henneberg("henneberg");
  EXPECT_EQ(why(henneberg.choose(1).value()), Why::GridIsCheaper);
  EXPECT_EQ(why(henneberg.choose(1000).value()), Why::HalvingIsCheaper);
}

TEST(CostModel, AddsUpWhatIsCounted) {
  const Operations operations{10, 20, 30};
  const MeshWork grid{.grid_samples = 1000};
  const MeshWork halving{.leaf_samples = 1000, .boxes = 10};
  MeshWork both = grid;
  both.add(halving);
  EXPECT_DOUBLE_EQ(cost(both, operations), cost(grid, operations) + cost(halving, operations));
  EXPECT_LT(cost(grid, operations), cost({.leaf_samples = 1000}, operations));
  EXPECT_DOUBLE_EQ(drawing_cost(100, 3), 3 * drawing_cost(100, 1));
}

}  // namespace
}  // namespace saddle
