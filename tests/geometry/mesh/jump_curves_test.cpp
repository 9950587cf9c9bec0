// Lines of the mesh at the jumps and edges of surfaces, compared with curves of known equations in
// both directions, without any part of the mesher.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include "mesh/mesher/mesher.h"
#include "mesh_requests.h"
#include "surface_from_text.h"

namespace saddle {
namespace {

/// Of the tolerance, both ways.
constexpr double kMost = 1.02;
/// Places on a curve, and on each line of the mesh.
constexpr int kOnCurve = 1000;
constexpr int kOnChord = 8;

using Curve = std::vector<dvec2>;
using Segment = std::array<dvec3, 2>;

Curve ellipse(const dvec2& centre, double a, double b) {
  Curve curve;
  for (int k = 0; k <= kOnCurve; ++k) {
    const double angle = 2 * kPi * k / kOnCurve;
    curve.push_back(centre + dvec2(a * std::cos(angle), b * std::sin(angle)));
  }
  return curve;
}

Curve circle(const dvec2& centre, double radius) {
  return ellipse(centre, radius, radius);
}

/// From the end of u to an apex and back: |v - apex.y| = slope (u - apex.x).
Curve wedge(const dvec2& apex, double slope) {
  Curve curve;
  for (int k = -kOnCurve; k <= kOnCurve; ++k) {
    const double along = (1 - apex.x) * std::abs(k) / kOnCurve;
    curve.push_back(apex + along * dvec2(1, k < 0 ? slope : -slope));
  }
  return curve;
}

Curve sine(double height, double frequency) {
  Curve curve;
  for (int k = -kOnCurve; k <= kOnCurve; ++k) {
    const double u = static_cast<double>(k) / kOnCurve;
    curve.emplace_back(u, height * std::sin(frequency * u));
  }
  return curve;
}

/// A surface over -1..1, -1..1 that is flat where its curves are not steep boundaries.
struct CurveCase {
  const char* text;
  std::vector<double> sheets;  // heights; empty: all triangles are one sheet
  std::vector<Curve> curves;
  bool is_steep = false;
};

const std::vector<CurveCase>& all_curves() {
  static const std::vector<CurveCase> cases = {
      {"(hypot(u-0.13,v+0.21)<0.43)?1:0", {0, 1}, {circle({0.13, -0.21}, 0.43)}},
      {"(hypot(u-0.31,v-0.07)<0.1)?1:0", {0, 1}, {circle({0.31, 0.07}, 0.1)}},
      {"((u-0.05)^2+((v-0.1)/0.4)^2<0.49)?1:0", {0, 1}, {ellipse({0.05, 0.1}, 0.7, 0.28)}},
      {"((u+0.1)^2+((v-0.1)/0.15)^2<0.64)?1:0", {0, 1}, {ellipse({-0.1, 0.1}, 0.8, 0.12)}},
      {"(abs(v-0.07)<0.5*(u+0.31))?1:0", {0, 1}, {wedge({-0.31, 0.07}, 0.5)}},
      {"(abs(v-0.07)<0.2*(u+0.31))?1:0", {0, 1}, {wedge({-0.31, 0.07}, 0.2)}},
      {"(v>0.3*sin(5*u))?1:0", {0, 1}, {sine(0.3, 5)}},
      {"(v>0.2*sin(13*u))?1:0", {0, 1}, {sine(0.2, 13)}},
      {"(hypot(u-0.13,v+0.21)<0.43)?0:nan", {}, {circle({0.13, -0.21}, 0.43)}},
      {"((u-0.05)^2+((v-0.1)/0.4)^2<0.49)?0:nan", {}, {ellipse({0.05, 0.1}, 0.7, 0.28)}},
      {"(abs(v-0.07)<0.5*(u+0.31))?0:nan", {}, {wedge({-0.31, 0.07}, 0.5)}},
      {"(v>0.3*sin(5*u))?0:nan", {}, {sine(0.3, 5)}},
      {"sqrt(abs(hypot(u-0.1,v-0.05)-0.62)-0.1)",
       {},
       {circle({0.1, 0.05}, 0.52), circle({0.1, 0.05}, 0.72)},
       true}};
  return cases;
}

/// Sides of exactly one triangle of a sheet that are not on the edge of the domain. Positions that
/// are equal up to rounding are one.
std::vector<Segment> border_of_sheet(const Mesh& mesh, const CurveCase& flat, std::size_t sheet) {
  constexpr double kRounding = 1e-12;
  using Key = std::array<long long, 3>;
  std::map<std::array<Key, 2>, std::pair<int, Segment>> sides;
  const auto key = [&](const dvec3& p) {
    const dvec3 steps = p / kRounding;
    return Key{std::llround(steps.x), std::llround(steps.y), std::llround(steps.z)};
  };
  for (const Triangle& t : mesh.triangles) {
    const bool is_own = flat.sheets.empty() || std::ranges::all_of(t, [&](std::uint32_t k) {
                          return mesh.position[k].z == flat.sheets[sheet];
                        });
    for (std::size_t k = 0; is_own && k < 3; ++k) {
      const Segment side = {mesh.position[t[k]], mesh.position[t[(k + 1) % 3]]};
      std::array<Key, 2> keys = {key(side[0]), key(side[1])};
      if (keys[1] < keys[0]) std::swap(keys[0], keys[1]);
      const auto added = sides.try_emplace(keys, 0, side).first;
      ++added->second.first;
    }
  }
  std::vector<Segment> border;
  for (const auto& [keys, counted] : sides) {
    const auto& [count, side] = counted;
    const auto& [a, b] = side;
    const auto is_end = [](double at) { return std::abs(std::abs(at) - 1) <= kRounding; };
    const bool is_at_end_of_u = is_end(a.x) && is_end(b.x);
    const bool is_at_end_of_v = is_end(a.y) && is_end(b.y);
    if (count == 1 && !is_at_end_of_u && !is_at_end_of_v) border.push_back(side);
  }
  return border;
}

double distance_from_segment(const dvec3& p, const Segment& segment) {
  const auto& [a, b] = segment;
  const dvec3 way = b - a;
  const double square = glm::dot(way, way);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return glm::distance(p, a + share * way);
}

/// Of every kStride-th place of a curve the nearest one; then of the segments beside it.
double distance_from_curve(const dvec2& p, const Curve& curve) {
  constexpr std::size_t kStride = 20;
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < curve.size(); i += kStride) {
    if (glm::distance(p, curve[i]) < glm::distance(p, curve[nearest])) nearest = i;
  }
  double least = std::numeric_limits<double>::infinity();
  const std::size_t last = std::min(nearest + kStride, curve.size() - 1);
  for (std::size_t i = nearest - std::min(nearest, kStride); i < last; ++i)
    least = std::min(
        least, distance_from_segment(dvec3(p, 0), {dvec3(curve[i], 0), dvec3(curve[i + 1], 0)}));
  return least;
}

/// The largest distance of lines in space from curves at one height, and of the curves from the
/// lines.
std::array<double, 2> largest_distances(const std::vector<Segment>& lines,
                                        const std::vector<Curve>& curves, double height) {
  std::array<double, 2> most = {0, 0};
  for (const auto& [a, b] : lines) {
    for (int k = 0; k < kOnChord; ++k) {
      const dvec3 p = glm::mix(a, b, (k + 0.5) / kOnChord);
      double least = std::numeric_limits<double>::infinity();
      for (const Curve& curve : curves)
        least = std::min(least, std::hypot(distance_from_curve(dvec2(p), curve), p.z - height));
      most[0] = std::max(most[0], least);
    }
  }
  for (const Curve& curve : curves) {
    for (const dvec2& at : curve) {
      if (std::max(std::abs(at.x), std::abs(at.y)) > 1) continue;
      double least = std::numeric_limits<double>::infinity();
      for (const Segment& line : lines)
        least = std::min(least, distance_from_segment(dvec3(at, height), line));
      most[1] = std::max(most[1], least);
    }
  }
  return most;
}

class JumpCurves : public testing::TestWithParam<std::tuple<double, bool>> {};

TEST_P(JumpCurves, AreWithinTheToleranceBothWays) {
  const auto [share, has_grid_lines] = GetParam();
  for (const CurveCase& flat : all_curves()) {
    MeshRequest request = within_share(share);
    if (!has_grid_lines) request.lines = {0, 0};
    const MeshResult result = try_mesh(height_field(flat.text), request).value();
    for (std::size_t sheet = 0; sheet < std::max<std::size_t>(flat.sheets.size(), 1); ++sheet) {
      const auto border = border_of_sheet(result.mesh, flat, sheet);
      const double height = flat.sheets.empty() ? 0 : flat.sheets[sheet];
      const auto [of_lines, of_curves] = largest_distances(border, flat.curves, height);
      const double allowed = kMost * *result.report.tolerance;
      // Places of a border inside of a steep boundary are on the surface, too.
      if (!flat.is_steep) {
        EXPECT_LE(of_lines, allowed) << flat.text << " sheet " << sheet;
      }
      EXPECT_LE(of_curves, allowed) << flat.text << " sheet " << sheet;
    }
    EXPECT_LE(result.report.max_error, *result.report.tolerance) << flat.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Tolerances, JumpCurves,
                         testing::Combine(testing::Values(1e-3, 1e-4), testing::Bool()));

}  // namespace
}  // namespace saddle
