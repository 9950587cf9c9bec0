#include "mesh/grid/degenerate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

bool has_finite_tangents(const SurfacePoint& point) {
  return std::isfinite(safe_length(point.r_u)) && std::isfinite(safe_length(point.r_v));
}

bool any_vertex_is_regular(const Grid& grid) {
  auto singular = grid.singular.begin();  // ascending, as the vertices
  for (std::size_t vertex = 0; vertex < grid.vertex_count(); ++vertex) {
    if (singular != grid.singular.end() && *singular == vertex) {
      ++singular;
    } else if (grid.is_used(vertex)) {
      return true;
    }
  }
  return false;
}

/// Some of the vertices, all of them used and singular, with their tangents.
std::vector<SurfacePoint> probe(const Surface& surface, const Grid& grid, unsigned threads) {
  std::vector<dvec2> uv;
  const std::size_t stride = grid.singular.size() / kStandForAll + 1;
  for (std::size_t k = 0; k < grid.singular.size(); k += stride) {
    uv.push_back(grid.uv(grid.singular[k]));
  }
  return evaluate(surface, uv, threads);
}

/// Whether the tangents are finite and parallel at all points. The axes are scaled first: an
/// upright sheet is no curve, although its tangents are parallel to rounding.
bool all_degenerate(std::span<const SurfacePoint> points, const dvec3& scale) {
  for (SurfacePoint point : points) {
    if (!has_finite_tangents(point)) return false;
    point.r_u *= scale;
    point.r_v *= scale;
    if (unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), false)) return false;
  }
  return true;
}

bool any_centre_is_regular(const Surface& surface, const Grid& grid, unsigned threads) {
  std::vector<dvec2> centres;
  const std::size_t stride = grid.cell_count() / kStandForAll + 1;
  for (std::size_t cell = 0; cell < grid.cell_count(); cell += stride) {
    if (!grid.is_kept(cell)) continue;
    centres.push_back(grid.cell_centre(cell));
  }
  const std::vector<SurfacePoint> points = evaluate(surface, centres, threads);
  return std::ranges::any_of(points, [](const SurfacePoint& point) {
    return unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), false).has_value();
  });
}

/// Whether all used vertices are on the line through the first and the one farthest from it.
bool is_straight(const Grid& grid) {
  std::vector<dvec3> points;
  for (const std::size_t vertex : grid.singular) points.push_back(grid.local(vertex));
  const auto farther = [&](const dvec3& a, const dvec3& b) {
    return glm::distance(a, points[0]) < glm::distance(b, points[0]);
  };
  const dvec3 end = *std::max_element(points.begin(), points.end(), farther);
  const dvec3 along = glm::normalize(end - points[0]);
  return std::all_of(points.begin(), points.end(), [&](const dvec3& p) {
    const double off = glm::length(glm::cross(along, p - points[0]));
    return off <= std::max(kSame * grid.diagonal, glm::length(rounding_of(p)));
  });
}

std::string explain(std::span<const SurfacePoint> points, const Domain& domain) {
  const auto& [u, v] = domain.names;
  const auto all_zero = [&](dvec3 SurfacePoint::*tangent) {
    return std::ranges::all_of(points,
                               [&](const SurfacePoint& p) { return p.*tangent == dvec3(0); });
  };
  if (all_zero(&SurfacePoint::r_u))
    return "the derivatives of x, y and z by " + u + " are 0 everywhere";
  if (all_zero(&SurfacePoint::r_v))
    return "the derivatives of x, y and z by " + v + " are 0 everywhere";
  return "the derivatives by " + u + " and by " + v + " are parallel everywhere: " + u + " and " +
         v + " move a point along the same curve";
}

}  // namespace

void require_two_dimensional(const Surface& surface, const Grid& grid, unsigned threads) {
  if (any_vertex_is_regular(grid)) return;
  const std::vector<SurfacePoint> points = probe(surface, grid, threads);
  if (!all_degenerate(points, axis_scale(grid.mesh.bounds))) return;
  if (any_centre_is_regular(surface, grid, threads)) return;
  throw Error(Status::Nothing,
              is_straight(grid) ? "the surface is a straight line" : "the surface is a curve", {},
              explain(points, surface.domain));
}

}  // namespace saddle
