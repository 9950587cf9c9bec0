// Leaves are as near to the surface as the mesh says, also between the places where they were
// measured: what is foreseen, creases, needles, sides that got vertices later. Distances are those
// of study/mesh_distance, which shares nothing with the mesher.
#include "mesh/error/distance_maximizer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "mesh/distance/crease_distance.h"
#include "mesh/distance/newton_step.h"
#include "mesh/mesher/mesher.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/options/resolve.h"
#include "study/mesh_distance.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// z = height - a x^2 - b x y - c y^2 over the triangle (0, 0), (1, 0), (0, 1) less its values at
/// the corners, which is 0 there: what is foreseen from (x, y).
NewtonStep rise_on(double a, double b, double c, double x, double y) {
  const double slope_x = a * (1 - 2 * x) - b * y;
  const double slope_y = c * (1 - 2 * y) - b * x;
  const double height = a * x * (1 - x) - b * x * y + c * y * (1 - y);
  return newton_step_from({slope_x, slope_y, -2 * a, -b, -2 * c}, height, x, y);
}

TEST(NewtonStep, OfABowlIsItsTop) {
  // Highest at (0.3, 0.45): 0.3 = a (1 - 2 x) - b y = 0 and the same in y.
  const double a = 1;
  const double b = 0.8888888888888888;
  const double c = 2.6666666666666665;
  const double top = a * 0.3 * 0.7 - b * 0.3 * 0.45 + c * 0.45 * 0.55;
  const NewtonStep newton_step = rise_on(a, b, c, 0.25, 0.4);
  EXPECT_GT(newton_step.height, 0.98 * top);
  EXPECT_LE(newton_step.height, top * (1 + 1e-12));
  EXPECT_NEAR(0.25 + newton_step.to_b, 0.3, 0.02);
  EXPECT_NEAR(0.4 + newton_step.to_c, 0.45, 0.02);
  const NewtonStep below = newton_step_from({-0.1, 0, 2, 0, 2}, -1, 0.3, 0.3);
  EXPECT_GT(below.height, 1);
}

TEST(NewtonStep, LeadsUphillAlongACylinderAndStaysInTheTriangle) {
  const NewtonStep newton_step = rise_on(1, 0, 0, 0.3, 0.2);
  EXPECT_NEAR(newton_step.height, 0.25, 0.01);
  EXPECT_NEAR(0.3 + newton_step.to_b, 0.5, 0.07);
  const NewtonStep at_side = newton_step_from({5, 0, -0.1, 0, -0.1}, 0.1, 0.5, 0.4);
  EXPECT_LE(0.5 + at_side.to_b + 0.4 + at_side.to_c, 1 + 1e-12);
  EXPECT_GT(at_side.height, 0.1);
}

TEST(NewtonStep, IsNoneInAHollow) {
  EXPECT_EQ(newton_step_from({0, 0, -1, 0, -1}, 0.2, 0.3, 0.3).height, 0.2);
  EXPECT_EQ(newton_step_from({0.1, 0, 1, 0, 1}, 0.2, 0.3, 0.3).height, 0.2);
}

TEST(CreaseDistance, FindsACuspAndTheNearestPoint) {
  const Surface surface = surface_from_text("u", "v^2", "v^3", {-1, 1, -1, 1}, {}, Order::Second);
  const Line across = {dvec2(0.3, -0.1), dvec2(0.3, 0.25)};
  const auto cusp = crease_places(surface, std::span(&across, 1), 1)[0];
  ASSERT_TRUE(cusp);
  EXPECT_NEAR(cusp->uv.y, 0, 1e-3);
  EXPECT_FALSE(cusp->is_plain);
  const Line beside = {dvec2(0.3, 0.2), dvec2(0.3, 0.201)};
  EXPECT_FALSE(crease_places(surface, std::span(&beside, 1), 1)[0]);
  // Its middle is 0.1 from the surface at v = 0.5 along its normal, its parameters are somewhat
  // off.
  const dvec3 middle = dvec3(0.2, 0.25, 0.125) + 0.1 * glm::normalize(dvec3(0, -0.75, 1));
  const dvec3 aside(0.1, 0, 0);
  const MiddleOfChord chord{
      {middle - aside, middle + aside}, {dvec2(0.15, 0.4), dvec2(0.35, 0.4)}, {0.5, 0.5}, 1};
  EXPECT_NEAR(distances_from_surface(surface, std::span(&chord, 1), 1)[0], 0.1, 1e-6);
  MiddleOfChord farther = chord;
  farther.known = 0.09;
  EXPECT_NEAR(distances_from_surface(surface, std::span(&farther, 1), 1)[0], 0.1, 1e-6);
}

TEST(CreaseDistance, FindsTheNearestPointWhereTheSurfaceIsEverSteeper) {
  // Nowhere farther than the chord is long along u.
  for (const char* z : {"abs(u)^0.2", "abs(u)^0.1"}) {
    const Surface surface = surface_from_text("u", "v", z, {-1, 1, -1, 1}, {}, Order::Second);
    const std::array ends = {dvec2(1e-30, 0.1), dvec2(1e-4, 0.2)};
    const auto at_ends = evaluate(surface, ends, 1);
    const MiddleOfChord chord{{at_ends[0].position, at_ends[1].position}, ends, {2e-4, 0.1}, 1e-3};
    EXPECT_LT(distances_from_surface(surface, std::span(&chord, 1), 1)[0], 1e-4) << z;
  }
}

TEST(CreaseDistance, FindsWhereTheSurfaceIsUprightAsNearAsItsHeightNeeds) {
  const Line across = {dvec2(-0.02, 0), dvec2(0.05, 0)};
  for (const char* z : {"cbrt(abs(u))", "abs(u)^0.25", "cbrt(max(0,u))"}) {
    const Surface root = surface_from_text("u", "v", z, {-1, 1, -1, 1}, {}, Order::Second);
    const auto crease = crease_places(root, std::span(&across, 1), 1)[0];
    ASSERT_TRUE(crease) << z;
    EXPECT_FALSE(crease->is_plain) << z;
    EXPECT_NEAR(evaluate(root, std::span(&crease->uv, 1), 1)[0].position.z, 0, 1e-3) << z;
  }
}

TEST(CreaseDistance, FindsCreasesWithFiniteSlopesAndTellsThemApart) {
  const Line across = {dvec2(-0.02, 0), dvec2(0.05, 0)};
  for (const char* z : {"abs(u)", "0.1*abs(u)", "max(u,u^2)"}) {
    const Surface roof = surface_from_text("u", "v", z, {-1, 1, -1, 1}, {}, Order::Second);
    const auto crease = crease_places(roof, std::span(&across, 1), 1)[0];
    ASSERT_TRUE(crease) << z;
    EXPECT_TRUE(crease->is_plain) << z;
    EXPECT_NEAR(crease->uv.x, 0, 1e-4) << z;
  }
}

struct ToleranceCase {
  const char* name;
  std::vector<double> shares;  ///< tolerances, of the diagonal
};

class WithinTolerance : public testing::TestWithParam<ToleranceCase> {};

TEST_P(WithinTolerance, BothWaysBetweenSamples) {
  const auto& [name, shares] = GetParam();
  Scene given;
  if (std::string(name) == "peak") {
    assign(given, "z=exp(-40*((u-0.3)^2+(v+0.2)^2))");
  } else {
    given = gallery_scene(*find_gallery_entry(name));
  }
  const Scene scene = resolve(given);
  const Subject subject(scene, scene.surfaces.at(0));
  const MeshDistance distance_of(subject);
  for (const double share : shares) {
    double length = 0;
    MeshRequest options;
    options.tolerance = [&](const Probe& probe) -> Tolerance {
      length = share * probe.bounds().diagonal();
      return [&length](const dvec3&) { return length; };
    };
    options.lines = {0, 0};
    const auto mesh = try_mesh(subject.surface, options);
    ASSERT_TRUE(mesh) << share;
    EXPECT_LE(mesh->report.max_error, length) << share;
    const double distance = distance_of(mesh->mesh);
    EXPECT_GT(distance, 0.3 * length) << share;
    EXPECT_LE(distance, length) << share;
  }
}

/// Each was above its tolerance, by up to 3.7 times.
INSTANTIATE_TEST_SUITE_P(Gallery, WithinTolerance,
                         testing::Values(ToleranceCase{"peak", {1e-4}},
                                         ToleranceCase{"klein-bottle", {1e-3}},
                                         ToleranceCase{"kuen", {1e-4}},
                                         ToleranceCase{"swallowtail", {1e-2}},
                                         ToleranceCase{"guimard", {1e-2, 1e-3}},
                                         ToleranceCase{"bourke-harmonic", {1e-2, 1e-3}}),
                         [](const auto& test) {
                           std::string name = test.param.name;
                           std::erase(name, '-');
                           return name;
                         });

}  // namespace
}  // namespace saddle
