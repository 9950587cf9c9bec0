#include "conformance/gallery_accuracy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "conformance/rounding.h"
#include "formula/derive.h"
#include "formula/lower.h"
#include "formula/scope.h"
#include "scene/model/prepare.h"
#include "study/exact_surface.h"
#include "surface/normal.h"

namespace saddle::testing {
namespace {

constexpr std::size_t kOutputs = 9;  // x y z, their derivatives by u, then by v

/// Constants are folded as doubles: pi/6 is off by half a last place for each of two operations.
constexpr double kConstantUlps = 2;

/// What cross product and normalisation add to an angle, in radians.
constexpr double kCrossRounding = 8 * 0x1p-53;

std::vector<NodeId> with_tangents(Graph& graph, std::vector<NodeId> roots) {
  const std::vector<NodeId> position = roots;
  for (const Symbol by : {kSymbolU, kSymbolV}) {
    const std::vector<NodeId> slopes = derive(graph, position, by);
    roots.insert(roots.end(), slopes.begin(), slopes.end());
  }
  return roots;
}

/// Positions and tangents of a scene's surface as nodes.
struct Formulas {
  Graph graph;
  std::vector<NodeId> roots;
};

/// What the tapes are compiled from.
Formulas evaluated_formulas(const Scene& scene) {
  const SurfaceSpec& spec = scene.surfaces.at(0);
  Graph graph;
  Scope scope(graph, surface_definitions(scene, spec), surface_view(scene, spec));
  const std::array<NodeId, 3> r = position(scope);
  std::vector<NodeId> roots(r.begin(), r.end());
  roots = with_tangents(graph, scope.bind(roots, scene.t));
  Graph lowered = lower(graph, roots);
  return {std::move(lowered), roots};
}

/// Of points of the domain, most may be where a surface is not defined.
constexpr int kTries = 16;

std::vector<dvec2> interior_points(const Domain& domain, int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto unit = [&random] { return static_cast<double>(random() >> 11U) * 0x1p-53; };
  std::vector<dvec2> points;
  for (int i = 0; i < count; ++i) {
    const double u = domain.u0 + (domain.u1 - domain.u0) * unit();
    points.emplace_back(u, domain.v0 + (domain.v1 - domain.v0) * unit());
  }
  return points;
}

double last_place(double x) {
  return std::nextafter(std::fabs(x), HUGE_VAL) - std::fabs(x);
}

/// The truth at one point, and how far rounding may move it.
class Truth {
 public:
  explicit Truth(const Scene& scene)
      : exact_(scene, scene.surfaces.at(0)),
        evaluated_(evaluated_formulas(scene)),
        bound_(evaluated_.graph, evaluated_.roots, kConstantUlps) {}

  ExactPoint values(const dvec2& uv) const { return exact_(uv.x, uv.y); }

  std::array<double, kOutputs> bounds(const dvec2& uv) const {
    std::vector<double> values(evaluated_.graph.size());
    for (NodeId id = 0; id < values.size(); ++id) {
      const Node& node = evaluated_.graph[id];
      const auto [a, b, c] = node.args;
      values[id] = node.op == Op::Constant   ? node.value
                   : node.op == Op::Variable ? (node.symbol == kSymbolU ? uv.x : uv.y)
                                             : apply(node.op, values[a], values[b], values[c]);
    }
    const std::vector<double> all = bound_(values);
    std::array<double, kOutputs> result{};
    for (std::size_t k = 0; k < kOutputs; ++k) result[k] = all[evaluated_.roots[k]];
    return result;
  }

 private:
  ExactSurface exact_;
  Formulas evaluated_;
  RoundingBound bound_;
};

void compare_position(const dvec3& computed, const RealVector& exact,
                      std::span<const double, kOutputs> bounds, double size,
                      GalleryAccuracy& result) {
  double largest = 0;
  for (const Real& x : exact) largest = std::max(largest, std::fabs(static_cast<double>(x)));
  for (int i = 0; i < 3; ++i) {
    const double error = static_cast<double>(abs(computed[i] - exact[i]));
    result.box_ulps = std::max(result.box_ulps, error / last_place(size));
    result.point_ulps = std::max(result.point_ulps, error / last_place(largest));
    if (error > 0) result.rounding = std::max(result.rounding, error / bounds[i]);
  }
}

void compare_normal(const dvec3& normal, const ExactPoint& exact, bool flip,
                    std::span<const double, kOutputs> bounds, GalleryAccuracy& result) {
  constexpr double kDegrees = 57.29577951308232;
  RealVector across = cross(exact.r_u, exact.r_v);
  const Real size = length(across);
  const RealVector computed = {normal.x, normal.y, normal.z};
  const Real sine = length(cross(computed, across)) / size;
  const Real cosine = normal.x * across[0] + normal.y * across[1] + normal.z * across[2];
  const double angle =
      atan2(static_cast<double>(sine), static_cast<double>(Real((flip ? -cosine : cosine) / size)));
  const auto norm = [&](int first) {
    return std::hypot(bounds[first], bounds[first + 1], bounds[first + 2]);
  };
  const Real moved = norm(3) * length(exact.r_v) + norm(6) * length(exact.r_u);
  const double allowed =
      static_cast<double>(Real(moved / size)) +
      kCrossRounding * static_cast<double>(Real(length(exact.r_u) * length(exact.r_v) / size));
  result.degrees = std::max(result.degrees, angle * kDegrees);
  result.normal_rounding = std::max(result.normal_rounding, angle / allowed);
  ++result.normals;
}

}  // namespace

GalleryAccuracy measure_accuracy(const GalleryEntry& entry, int points, std::uint64_t seed) {
  const Scene scene = gallery_scene(entry);
  const Surface surface = prepare_surface(scene, scene.surfaces.at(0)).surface;
  const Truth truth(scene);
  const std::vector<dvec2> uv = interior_points(surface.domain, kTries * points, seed);
  const std::vector<SurfacePoint> computed = evaluate(surface, uv, 1);
  double size = 0;
  for (const SurfacePoint& point : computed) {
    for (int i = 0; i < 3; ++i) {
      if (std::isfinite(point.position[i])) size = std::max(size, std::fabs(point.position[i]));
    }
  }
  GalleryAccuracy result;
  result.name = entry.name;
  for (std::size_t i = 0; i < uv.size() && result.points < points; ++i) {
    const ExactPoint exact = truth.values(uv[i]);
    const bool finite = std::ranges::all_of(exact.r, [](const Real& x) { return isfinite(x); });
    if (!finite) continue;
    const std::array<double, kOutputs> bounds = truth.bounds(uv[i]);
    compare_position(computed[i].position, exact.r, bounds, size, result);
    ++result.points;
    const auto normal = unit_normal(computed[i], 1, 1, surface.flip);
    if (normal) compare_normal(*normal, exact, surface.flip, bounds, result);
  }
  return result;
}

}  // namespace saddle::testing
