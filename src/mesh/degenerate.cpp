#include "mesh/degenerate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Cells whose centres are tried when all vertices are singular, as all are of a sphere of one
/// cell.
constexpr std::size_t kProbes = 1024;
/// Points this near to a line, as a part of the diagonal, are on it.
constexpr double kStraight = 1e-9;

bool has_finite_tangents(const SurfacePoint& point) {
  return std::isfinite(safe_length(point.r_u)) && std::isfinite(safe_length(point.r_v));
}

/// Factors that give each coordinate an extent of 1, or leave it alone where it has none.
dvec3 axis_scale(const Grid& grid) {
  Bounds bounds;
  for (std::size_t vertex = 0; vertex < grid.points.size(); ++vertex) {
    if (grid.vertex_used[vertex]) bounds.add(grid.points[vertex].position);
  }
  dvec3 scale(1);
  for (int k = 0; k < 3; ++k) {
    if (std::isnormal(1 / bounds.size()[k])) scale[k] = 1 / bounds.size()[k];
  }
  return scale;
}

/// Whether the tangents of every used vertex are finite and parallel. That does not depend on the
/// scale of the axes, but roundoff does: 1e9*u*v is no curve although its sheets are nearly
/// upright.
bool all_degenerate(const Grid& grid) {
  const dvec3 scale = axis_scale(grid);
  for (std::size_t vertex = 0; vertex < grid.points.size(); ++vertex) {
    if (!grid.vertex_used[vertex]) continue;
    SurfacePoint point = grid.points[vertex];
    if (!has_finite_tangents(point)) return false;
    point.r_u *= scale;
    point.r_v *= scale;
    if (unit_normal(point, safe_length(point.r_u), safe_length(point.r_v), false)) return false;
  }
  return true;
}

bool any_centre_is_regular(const Surface& surface, const Grid& grid, unsigned threads) {
  std::vector<std::size_t> cells;
  std::vector<dvec2> centres;
  const std::size_t stride = grid.cell_count() / kProbes + 1;
  for (std::size_t cell = 0; cell < grid.cell_count(); cell += stride) {
    if (!grid.cell_kept[cell]) continue;
    cells.push_back(cell);
    centres.push_back(grid.cell_centre(cell));
  }
  const std::vector<SurfacePoint> points = evaluate(surface, centres, threads);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const dvec2 scale = glm::max(grid.tangent_scale(grid.vertices(cells[k])[0]),
                                 dvec2(safe_length(points[k].r_u), safe_length(points[k].r_v)));
    if (unit_normal(points[k], scale.x, scale.y, false)) return true;
  }
  return false;
}

/// Whether all used vertices are on the line through the first and the one farthest from it.
bool is_straight(const Grid& grid) {
  std::vector<dvec3> points;
  for (std::size_t vertex = 0; vertex < grid.points.size(); ++vertex) {
    if (grid.vertex_used[vertex]) points.push_back(grid.local(vertex));
  }
  const auto farther = [&](const dvec3& a, const dvec3& b) {
    return glm::distance(a, points[0]) < glm::distance(b, points[0]);
  };
  const dvec3 end = *std::max_element(points.begin(), points.end(), farther);
  const dvec3 along = glm::normalize(end - points[0]);
  return std::all_of(points.begin(), points.end(), [&](const dvec3& p) {
    const double off = glm::length(glm::cross(along, p - points[0]));
    return off <= std::max(kStraight * grid.diagonal, glm::length(rounding(p)));
  });
}

std::string explain(const Grid& grid) {
  dvec2 largest(0);
  for (const dvec2& lengths : grid.tangent_lengths) largest = glm::max(largest, lengths);
  if (largest.x == 0) return "the derivatives of x, y and z by u are 0 everywhere";
  if (largest.y == 0) return "the derivatives of x, y and z by v are 0 everywhere";
  return "the derivatives by u and by v are parallel everywhere: u and v move a point along the "
         "same curve";
}

}  // namespace

void require_two_dimensional(const Surface& surface, const Grid& grid, unsigned threads) {
  if (!all_degenerate(grid) || any_centre_is_regular(surface, grid, threads)) return;
  throw Error(Status::Nothing,
              is_straight(grid) ? "the surface is a straight line" : "the surface is a curve", {},
              explain(grid));
}

}  // namespace saddle
