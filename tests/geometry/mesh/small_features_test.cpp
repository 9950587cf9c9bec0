// Discs, islands, holes and slots of any size are in the mesh, with grid lines and without.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <string>

#include "base/format.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/mesher/mesher.h"
#include "mesh/model/mesh_report.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

constexpr double kFeatureTolerance = 3e-3;
/// Distances of jump lines from their chords are measured at landmarks alone.
constexpr double kNearChord = 2.5 * kFeatureTolerance;

MeshResult mesh_with_lines(const std::string& z, int lines) {
  MeshRequest request = within_length(kFeatureTolerance);
  request.lines = {lines, lines};
  std::optional<MeshResult> result = try_mesh(height_field(z), request);
  return result ? std::move(*result) : MeshResult();
}

/// The distance of a point from the nearest triangle.
double distance_of(const Mesh& mesh, const dvec3& p) {
  Grid grid;
  grid.mesh = mesh;
  double least = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles)
    least = std::min(least, distance_from(grid, std::span(&t, 1), {p.x, p.y}, p));
  return least;
}

/// The largest distance of points on circles around a centre, at a height, from a mesh.
double distance_of_circle(const Mesh& mesh, const dvec2& centre, double radius, double height) {
  constexpr int kPoints = 12;
  double worst = 0;
  for (int k = 0; k < kPoints; ++k) {
    const double angle = 2 * std::numbers::pi * k / kPoints;
    const dvec2 p = centre + radius * dvec2(std::cos(angle), std::sin(angle));
    worst = std::max(worst, distance_of(mesh, dvec3(p, height)));
  }
  return worst;
}

std::string number(double value) {
  return formatted("%.17g", value);
}

class SmallFeatures : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(WithLinesAndWithout, SmallFeatures, testing::Values(0, 16));

TEST_P(SmallFeatures, DiscsAreInTheMesh) {
  for (const double radius : {0.3, 0.045, 0.02, 3e-3, 3e-4, 1e-4}) {
    for (const dvec2& at : {dvec2(0), dvec2(0.4, 0.3), dvec2(-0.6123, 0.2718)}) {
      const std::string z =
          "(hypot(u-(" + number(at.x) + "),v-(" + number(at.y) + "))<" + number(radius) + ")?1:0";
      const MeshResult result = mesh_with_lines(z, GetParam());
      EXPECT_LE(distance_of_circle(result.mesh, at, radius, 1), kNearChord) << z;
      EXPECT_LE(distance_of_circle(result.mesh, at, radius, 0), kNearChord) << z;
      EXPECT_LE(result.report.max_error, kFeatureTolerance) << z;
      EXPECT_LT(result.mesh.triangles.size(), 2000U) << z;
    }
  }
}

TEST_P(SmallFeatures, IslandsAreInTheMeshBesideOtherParts) {
  for (const double radius : {0.02, 1e-3, 1e-4}) {
    const std::string z = "(hypot(u-0.3,v-0.2)<" + number(radius) + ")?1+u:((u<-0.5)?0.2*u:nan)";
    const MeshResult result = mesh_with_lines(z, GetParam());
    EXPECT_LE(distance_of(result.mesh, {0.3, 0.2, 1.3}), kFeatureTolerance) << z;
    EXPECT_LE(result.report.max_error, kFeatureTolerance) << z;
  }
}

TEST_P(SmallFeatures, HolesAreOpen) {
  // The distance of a hole's middle from the mesh is its radius, to the tolerance.
  for (const double radius : {0.3, 0.05, 0.02, 0.01}) {
    const std::string z = "min(1,1+sqrt(hypot(u+0.78722,v-0.58648)-" + number(radius) + "))";
    const MeshResult result = mesh_with_lines(z, GetParam());
    EXPECT_GE(distance_of(result.mesh, {-0.78722, 0.58648, 1}), radius - kNearChord) << z;
    EXPECT_GT(result.report.undefined_fraction, 0) << z;
  }
}

TEST_P(SmallFeatures, SlotsAreInTheMesh) {
  for (const double width : {1e-2, 1e-3, 1e-5}) {
    const std::string z = "(abs(u-0.31)<" + number(width) + ")?1:0";
    const MeshResult result = mesh_with_lines(z, GetParam());
    for (const double v : {-1.0, -0.7, 0.05, 0.4, 0.99})
      EXPECT_LE(distance_of(result.mesh, {0.31, v, 1}), kFeatureTolerance) << z << v;
  }
}

TEST_P(SmallFeatures, SlotsWithoutSurfaceAreOpen) {
  struct Slot {
    std::string across;
    double length;
  };
  for (const double depth : {1.2, 1.6, 2.3, 3.4}) {
    for (const auto& [across, length] :
         {Slot{"v-0.18015", 2}, Slot{"(u+v/5-0.18015)/sqrt(1.04)", 2 * std::sqrt(1.04)},
          Slot{"(u+v-0.1)/sqrt(2)", 1.9 * std::sqrt(2.0)}}) {
      const double half = depth * kFeatureTolerance;
      const MeshResult result =
          mesh_with_lines("(abs(" + across + ")<" + number(half) + ")?nan:0.2*v", GetParam());
      const double area = 4 * result.report.undefined_fraction;
      EXPECT_NEAR(area, 2 * half * length, 0.01 * half * length) << across << " < " << half;
    }
  }
}

TEST(SmallFeatures, AreNotCutOffByASingleCell) {
  const MeshResult half = mesh_with_lines("(u^2+v^2<0.5&&v>0)?1:0", 0);
  for (const dvec2& p : {dvec2(0, 0.1), dvec2(0.5, 0.3), dvec2(-0.6, 0.1), dvec2(0, 0.7)})
    EXPECT_LE(distance_of(half.mesh, dvec3(p, 1)), kFeatureTolerance);
  EXPECT_LE(distance_of(half.mesh, {0, -0.1, 0}), kFeatureTolerance);
}

TEST(SmallFeatures, ThatSamplesMissAreTold) {
  const std::optional<MeshResult> result =
      try_mesh(height_field("(hypot(u-0.403,v-0.302)<0.003)?1:0"),
               with_samples(within_length(kFeatureTolerance), 8, 8));
  ASSERT_TRUE(result);
  EXPECT_NEAR(result->report.max_error, 1, 1e-6);
}

}  // namespace
}  // namespace saddle
