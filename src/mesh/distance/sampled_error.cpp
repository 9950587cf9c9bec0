#include "mesh/distance/sampled_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>

#include "mesh/distance/newton_step.h"
#include "mesh/distance/triangle_error.h"
#include "mesh/grid/triangulate.h"
#include "mesh/model/segment.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// The point of a triangle nearest to `p`, as weights of its corners.
struct Nearest {
  double distance = std::numeric_limits<double>::infinity();
  dvec3 weights{0};
  bool inside = false;  ///< the triangle, straight below `p`
};

Nearest nearest_on_triangle(const std::array<dvec3, 3>& t, const dvec3& p) {
  const dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double square = glm::dot(normal, normal);
  // The weight of a corner is the area of p and the other two, as a part of the triangle's.
  const dvec3 weights = dvec3(glm::dot(glm::cross(t[1] - p, t[2] - p), normal),
                              glm::dot(glm::cross(t[2] - p, t[0] - p), normal),
                              glm::dot(glm::cross(t[0] - p, t[1] - p), normal));
  if (square > 0 && weights.x >= 0 && weights.y >= 0 && weights.z >= 0) {
    return {std::abs(glm::dot(p - t[0], normal)) / std::sqrt(square), weights / square, true};
  }
  double least = std::numeric_limits<double>::infinity();  // square of the distance
  double share = 0;
  int from = 0;
  for (int k = 0; k < 3; ++k) {
    // Only an edge that p is beyond can be nearest, unless by rounding p is inside of all.
    if (square > 0 && weights[(k + 2) % 3] > 0) continue;
    const auto [on_edge, offset] = nearest_on_segment(t[static_cast<std::size_t>(k)],
                                                      t[static_cast<std::size_t>((k + 1) % 3)], p);
    const double square_of_distance = glm::dot(offset, offset);
    if (!(square_of_distance < least)) continue;
    least = square_of_distance;
    share = on_edge;
    from = k;
  }
  Nearest nearest{std::sqrt(least), dvec3(0)};
  nearest.weights[from] = 1 - share;
  nearest.weights[(from + 1) % 3] = share;
  return nearest;
}

/// Weights of a triangle's corners at (u, v); some are negative outside.
dvec3 weights_at(const Grid& grid, const Triangle& t, const dvec2& uv) {
  const auto& at = grid.mesh.uv;
  const double per_whole = 1 / cross(at[t[1]] - at[t[0]], at[t[2]] - at[t[0]]);
  const auto weight = [&](std::size_t a, std::size_t b) {
    return cross(at[t[a]] - uv, at[t[b]] - uv) * per_whole;
  };
  return {weight(1, 2), weight(2, 0), weight(0, 1)};
}

Nearest nearest_on(const Grid& grid, const Triangle& t, const dvec3& p) {
  return nearest_on_triangle({grid.local(t[0]), grid.local(t[1]), grid.local(t[2])}, p);
}

/// The distance of a point, in local units, from triangles. `on_own`: its nearest point on `own`,
/// one of them. Others are searched where it is farther than `known`, in units of length.
double distance(const Grid& grid, std::span<const Triangle> triangles, const dvec3& p,
                const Triangle& own, const Nearest& on_own, double known) {
  double distance = on_own.distance;
  if (on_own.inside || distance <= grid.local_scale * known) return distance;
  for (const Triangle& t : triangles) {
    if (&t != &own) distance = std::min(distance, nearest_on(grid, t, p).distance);
  }
  return distance;
}

/// height_above() of a triangle's point at (u, v), in local units; 0 if (u, v) is not in the
/// triangle.
double height_of_triangle(const Grid& grid, const Below& below, const dvec3& p,
                          const dvec3& normal) {
  const auto& [triangle, weights] = below;
  const Triangle& t = *triangle;
  if (!(std::min({weights.x, weights.y, weights.z}) >= -kRounding)) return 0;
  const LoopTriangle corners = {loop_vector(grid.local(t[0])), loop_vector(grid.local(t[1])),
                                loop_vector(grid.local(t[2]))};
  return height_above(corners, loop_vector(weights), loop_vector(p), loop_vector(normal));
}

}  // namespace

Below triangle_below(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv) {
  Below best{&triangles.front(), dvec3(std::numeric_limits<double>::quiet_NaN())};
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Triangle& t : triangles) {
    const dvec3 weights = weights_at(grid, t, uv);
    const double depth = std::min({weights.x, weights.y, weights.z});
    if (!(depth > deepest)) continue;
    best = {&t, weights};
    deepest = depth;
    if (deepest > 0) break;  // inside: they do not overlap
  }
  return best;
}

Seen seen_at(const std::optional<Bounds>& clip, const Grid& grid,
             std::span<const Triangle> triangles, const dvec2& uv, const dvec3& position) {
  if (!clip) return {true, !triangles.empty()};
  Seen seen{clip->contains(position), false};
  if (triangles.empty()) return seen;
  const auto& [below, weights] = triangle_below(grid, triangles, uv);
  if (!(std::min({weights.x, weights.y, weights.z}) >= -kRounding)) return seen;
  const dvec3 inside = glm::clamp(weights, 0.0, 1.0);
  const Triangle& t = *below;
  const auto& p = grid.mesh.position;
  seen.triangles = clip->contains(inside.x * p[t[0]] + inside.y * p[t[1]] + inside.z * p[t[2]]);
  return seen;
}

double distance_from(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                     const dvec3& position, double known) {
  if (triangles.empty() || !is_finite(position)) return 0;
  const Triangle& own = *triangle_below(grid, triangles, uv).triangle;
  const dvec3 p = grid.local_scale * position;
  return distance(grid, triangles, p, own, nearest_on(grid, own, p), known) / grid.local_scale;
}

WeightedDistance nearest_weights(const Grid& grid, const Triangle& triangle,
                                 const dvec3& position) {
  if (!is_finite(position)) return {std::numeric_limits<double>::infinity(), dvec3(0)};
  const Nearest nearest = nearest_on(grid, triangle, grid.local_scale * position);
  return {nearest.distance / grid.local_scale, nearest.weights};
}

SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const SurfacePoint& point, bool flip, double known) {
  const double size_u = safe_length(point.r_u);
  return sampled_error(grid, triangles, uv, point.position,
                       unit_normal(point, size_u, safe_length(point.r_v), flip), known);
}

SampledError sampled_error(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                           const dvec3& position, const std::optional<dvec3>& normal,
                           double known) {
  if (triangles.empty() || !is_finite(position)) return {};
  const Below below = triangle_below(grid, triangles, uv);
  const Triangle& own = *below.triangle;
  const dvec3 p = grid.local_scale * position;
  const Nearest on_own = nearest_on(grid, own, p);
  dvec3 interpolated(0);
  for (int k = 0; k < 3; ++k) {
    interpolated += on_own.weights[k] * grid.mesh.normal[own[static_cast<std::size_t>(k)]];
  }
  double away = distance(grid, triangles, p, own, on_own, known);
  if (normal) away = std::max(away, height_of_triangle(grid, below, p, *normal));
  return {away / grid.local_scale, normal ? degrees_between(*normal, interpolated) : 0};
}

Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const SurfacePoint& point, bool flip) {
  if (triangles.empty() || !is_finite(point.position)) return {0, uv};
  const auto normal = unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), flip);
  return normal ? predict(grid, triangles, uv, point.position, *normal) : Predicted{0, uv};
}

Predicted predict(const Grid& grid, std::span<const Triangle> triangles, const dvec2& uv,
                  const dvec3& position, const dvec3& normal) {
  const dvec3 p = grid.local_scale * position;
  const Triangle* nearest = triangle_below(grid, triangles, uv).triangle;
  Nearest on_own = nearest_on(grid, *nearest, p);
  for (const Triangle& t : triangles) {
    if (on_own.inside) break;
    if (&t == nearest) continue;
    const Nearest on_it = nearest_on(grid, t, p);
    if (!on_it.inside && !(on_it.distance < on_own.distance)) continue;
    nearest = &t;
    on_own = on_it;
  }
  const Triangle& own = *nearest;
  const dvec3 corner = grid.local(own[0]);
  const dvec3 to_second = grid.local(own[1]) - corner;
  const dvec3 to_third = grid.local(own[2]) - corner;
  const auto& n = grid.mesh.normal;
  const StepShape shape =
      step_shape(loop_vector(to_second), loop_vector(to_third), loop_vector(n[own[1]] - n[own[0]]),
                 loop_vector(n[own[2]] - n[own[0]]), loop_vector(normal));
  const double facing = glm::dot(normal, glm::cross(to_second, to_third));
  const double above = glm::dot(p - corner, glm::cross(to_second, to_third));
  const NewtonStep step =
      newton_step_from(shape, above * facing < 0 ? -on_own.distance : on_own.distance,
                       on_own.weights.y, on_own.weights.z);
  const auto& at = grid.mesh.uv;
  // A step on the surface is taken for the same step on the triangle.
  return {step.height / grid.local_scale,
          uv + step.to_b * (at[own[1]] - at[own[0]]) + step.to_c * (at[own[2]] - at[own[0]])};
}

double distance_from_line(const Grid& grid, const Chord& chord, const dvec3& p) {
  const dvec3 first = grid.local(chord[0]);
  const dvec3 edge = grid.local(chord[1]) - first;
  const dvec3 off = p - first;
  return glm::length(off - glm::dot(off, edge) / glm::dot(edge, edge) * edge);
}

double distance_from_chord(const Grid& grid, const Chord& chord, const dvec3& position) {
  const bool has_length = grid.local(chord[0]) != grid.local(chord[1]);
  if (!has_length || !is_finite(position)) return 0;
  return distance_from_line(grid, chord, grid.local_scale * position) / grid.local_scale;
}

double degrees_of_chord(double chord) {
  return 2 * std::asin(std::min(chord / 2, 1.0)) * 180 / std::numbers::pi;
}

double chord_of_degrees(double degrees) {
  return 2 * std::sin(degrees / 2 * std::numbers::pi / 180);
}

}  // namespace saddle
