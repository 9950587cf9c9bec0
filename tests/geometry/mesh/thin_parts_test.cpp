// Slots on which alone a surface is defined, and gaps in it, that are narrower than the cells of
// the mesh: they are meshed over their whole length.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "mesh/mesher/mesher.h"
#include "mesh/model/triangle_tree.h"
#include "mesh_checks.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

MeshResult mesh_with_thin_part(const std::string& z) {
  const Surface surface = surface_from_text("u", "v", z.c_str(), {-1, 1, -1, 1}, {}, Order::Second);
  return try_mesh(surface, within_share(1e-3, 3)).value();
}

/// The largest distance of points (u(t), v(t), 0), t from -1 to 1, from a mesh, in tolerances.
template <class U, class V>
double worst_distance_along(const MeshResult& result, U u, V v) {
  constexpr int kPlaces = 2000;
  const TriangleTree tree(result.mesh.position, result.mesh.triangles);
  double worst = 0;
  for (int k = 0; k <= kPlaces; ++k) {
    const double t = -1 + 2.0 * k / kPlaces;
    worst = std::max(worst, tree.distance({u(t), v(t), 0}));
  }
  return worst / *result.report.tolerance;
}

TEST(ThinParts, SlotsAslantAreMeshedFromEndToEnd) {
  for (const char* width : {"1e-2", "1e-3", "1e-4", "2e-5"}) {
    const MeshResult result =
        mesh_with_thin_part("(abs(u-0.364*v+0.1167)<" + std::string(width) + ")?0:nan");
    const auto u = [](double t) { return 0.364 * t - 0.1167; };
    EXPECT_LE(worst_distance_along(result, u, [](double t) { return t; }), 1.02) << width;
    EXPECT_LT(result.mesh.triangles.size(), 4000U) << width;
  }
}

TEST(ThinParts, SlotsAlongCurvesAreMeshedFromEndToEnd) {
  const MeshResult wave = mesh_with_thin_part("(abs(u-0.3479*cos(1.57*v))<9e-5)?0:nan");
  const auto own = [](double t) { return t; };
  EXPECT_LE(worst_distance_along(
                wave, [](double t) { return 0.3479 * std::cos(1.57 * t); }, own),
            1.02);
  const MeshResult cusp = mesh_with_thin_part("(abs(u^3-v^2)<1.2e-4)?0:nan");
  EXPECT_LE(worst_distance_along(
                cusp, [](double t) { return t * t; }, [](double t) { return t * t * t; }),
            1.02);
  const MeshResult square = mesh_with_thin_part("(abs(abs(u)+abs(v)-0.5061)<1.5e-4)?0:nan");
  EXPECT_LE(worst_distance_along(
                square, [](double t) { return 0.5061 * t; },
                [](double t) { return 0.5061 * (1 - std::fabs(t)); }),
            1.02);
}

/// The tip of a slot lies anywhere within a leaf.
TEST(ThinParts, SlotsThatEndInTheSurfaceAreMeshedToTheirTips) {
  for (const double end : {0.5577, 0.5731, 0.5868, 0.6, 0.6113, 0.6259}) {
    for (const double wave : {0.0, 0.1576}) {
      const std::string height = std::to_string(wave) + "*sin(5.127*u)";
      const MeshResult result = mesh_with_thin_part("(abs(v-" + height + ")<1.734e-5&&hypot(u,v)<" +
                                                    std::to_string(end) + ")?0:nan");
      const auto v_at = [wave](double u) { return wave * std::sin(5.127 * u); };
      double low = 0;  // of u at the end
      for (double high = 1; high - low > 1e-12;) {
        const double u = 0.5 * (low + high);
        (std::hypot(u, v_at(u)) < end ? low : high) = u;
      }
      const double found = worst_distance_along(
          result, [low](double t) { return low * t; }, [&](double t) { return v_at(low * t); });
      const double told = result.report.max_error / *result.report.tolerance;
      EXPECT_LE(found, 1.02) << wave << " to " << end;
      EXPECT_LE(found, 1.1 * std::max(told, 0.9)) << wave << " to " << end;
    }
  }
}

/// hill * exp(-u^2 - 3 v^2) + sqrt(half width - |s|) on |s| <= half width, where s = u - slope * v
/// + offset: a strip with a sharp crest, as far from its edges as its height.
struct Tent {
  double half_width, slope, offset;
  double hill = 0;
  std::string z() const {
    return std::to_string(hill) + "*exp(-u^2-3*v^2)+sqrt(" + std::to_string(half_width) +
           "-abs(u-" + std::to_string(slope) + "*v+" + std::to_string(offset) + "))";
  }
};

/// The largest distance of a tent's points from a mesh, in tolerances.
double worst_distance_of(const Tent& tent, const MeshResult& result) {
  constexpr int kAlong = 4000;
  constexpr int kAcross = 8;
  const TriangleTree tree(result.mesh.position, result.mesh.triangles);
  double worst = 0;
  for (int k = 0; k <= kAlong; ++k) {
    const double v = -1 + 2.0 * k / kAlong;
    for (int i = -kAcross; i <= kAcross; ++i) {
      const double s = tent.half_width * i / kAcross;
      const double u = tent.slope * v - tent.offset + s;
      const double z =
          tent.hill * std::exp(-u * u - 3 * v * v) + std::sqrt(tent.half_width - std::fabs(s));
      if (std::fabs(u) <= 1) worst = std::max(worst, tree.distance({u, v, z}));
    }
  }
  return worst / *result.report.tolerance;
}

TEST(ThinParts, StripsWithACrestAreMeshedWithinTheToleranceAndToldSo) {
  for (const Tent& tent : {Tent{2.3e-5, -1, 0, 0.8}, Tent{0.0017, 0.8, 0.2578, 0.2}}) {
    const MeshResult result = mesh_with_thin_part(tent.z());
    EXPECT_LE(worst_distance_of(tent, result), 1.02) << tent.half_width;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << tent.half_width;
    EXPECT_LT(result.mesh.triangles.size(), 30000U) << tent.half_width;
  }
}

/// Vertices beside the crest would ask for others: ten times as many triangles.
TEST(ThinParts, ACrestIsMeshedByItself) {
  for (const auto& [tent, most] : {std::pair{Tent{2.3e-5, -2.14, -0.4464}, 4000U},
                                   std::pair{Tent{5e-4, 1.116, 0.2578}, 15000U}}) {
    const MeshResult result = mesh_with_thin_part(tent.z());
    EXPECT_LE(worst_distance_of(tent, result), 1.02) << tent.half_width;
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << tent.half_width;
    EXPECT_LT(result.mesh.triangles.size(), most) << tent.half_width;
  }
}

TEST(ThinParts, ErrorsOfStripsAreToldFromTheNearestTriangles) {
  const Tent tent{1e-3, 1.116, 0.2578};
  const Surface surface =
      surface_from_text("u", "v", tent.z().c_str(), {-1, 1, -1, 1}, {}, Order::Second);
  MeshRequest request = within_length(2e-4);
  request.max_triangles = 200'000;
  const MeshResult result = try_mesh(surface, request).value();
  const double told = result.report.max_error / *result.report.tolerance;
  const double found = worst_distance_of(tent, result);
  EXPECT_GT(found, 1.02);  // the limit of work stops the mesh
  EXPECT_LE(found, 1.1 * told);
  EXPECT_LE(told, 3 * found);
}

TEST(ThinParts, GapsAreLeftOpenWhereTheyAreWiderThanTheTolerance) {
  constexpr double kHalfWidth = 0.009;
  const MeshResult result = mesh_with_thin_part("(abs(v-u^2)<0.009)?nan:0.6*u");
  // The gap is 2 * 0.009 high for each u, of which the tolerance may cover some.
  EXPECT_NEAR(area_in_uv(result.mesh), 4 - 2 * 2 * kHalfWidth, 0.005);
  const double tolerance = *result.report.tolerance;
  for (const Triangle& t : result.mesh.triangles) {
    const dvec2 middle = (result.mesh.uv[t[0]] + result.mesh.uv[t[1]] + result.mesh.uv[t[2]]) / 3.0;
    const double height = std::fabs(middle.y - middle.x * middle.x);
    // The gap's edges have slopes of at most 2.
    ASSERT_GT(height, kHalfWidth - tolerance * std::hypot(1, 2)) << middle.x;
  }
}

TEST(ThinParts, GapsWithinTheToleranceCostNothing) {
  const MeshResult result = mesh_with_thin_part("(abs(v-u^2)<1e-5)?nan:0.6*u");
  EXPECT_LE(result.report.max_error, *result.report.tolerance);
  EXPECT_LT(result.mesh.triangles.size(), 4000U);
}

TEST(ThinParts, AreNoneOnALineThatLimitsAloneDefine) {
  // 0/0 at v=0, where u is negative. The limit there is 2u.
  const MeshResult result = mesh_with_thin_part("v/(u+sqrt(u^2-v))");
  EXPECT_LT(result.mesh.triangles.size(), 10'000U);
  EXPECT_LT(result.report.evaluations, 1'000'000U);
}

}  // namespace
}  // namespace saddle
