#include "mesh/polygon.h"

#include <limits>

#include "mesh/triangulate.h"

namespace saddle {

namespace {

/// Twice the area of a triangle in (u, v); exact for whole places, which are less than 2^17 apart.
double doubled_area(const dvec2& a, const dvec2& b, const dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

double doubled_area(std::span<const PolygonCorner> polygon) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += doubled_area(polygon[0].place, polygon[k].place, polygon[k + 1].place);
  }
  return sum;
}

/// The ear to cut off: its tip's index.
std::size_t best_ear(const Grid& grid, std::span<const PolygonCorner> polygon) {
  const double whole = doubled_area(polygon);
  const Mesh& mesh = grid.mesh;
  std::size_t best = 0;
  double best_sagitta = std::numeric_limits<double>::infinity();
  double best_length = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const PolygonCorner& before = polygon[(k + polygon.size() - 1) % polygon.size()];
    const PolygonCorner& after = polygon[(k + 1) % polygon.size()];
    const double ear = doubled_area(before.place, polygon[k].place, after.place);
    // What is left must have area too: corners on one straight side are no polygon.
    if (ear <= 0 || ear >= whole) continue;
    const dvec3& a = mesh.position[before.corner];
    const dvec3& b = mesh.position[after.corner];
    const double arc = sagitta(a, mesh.normal[before.corner], b, mesh.normal[after.corner]);
    const double length = glm::dot(b - a, b - a);
    const bool better = is_smaller(arc, best_sagitta) ||
                        (!is_smaller(best_sagitta, arc) && is_smaller(length, best_length));
    if (!better && best_length < std::numeric_limits<double>::infinity()) continue;
    best = k;
    best_sagitta = arc;
    best_length = length;
  }
  return best;
}

void append(const Grid& grid, const PolygonCorner& a, const PolygonCorner& b,
            const PolygonCorner& c, Array<Triangle>& triangles) {
  Triangle triangle = {a.corner, b.corner, c.corner};
  if (is_collapsed(grid, triangle)) return;
  if (grid.mirrored) std::swap(triangle[1], triangle[2]);
  triangles.push_back(triangle);
}

}  // namespace

void triangulate_polygon(const Grid& grid, std::vector<PolygonCorner> polygon,
                         Array<Triangle>& triangles) {
  while (polygon.size() > 3) {
    const std::size_t k = best_ear(grid, polygon);
    const std::size_t before = (k + polygon.size() - 1) % polygon.size();
    const std::size_t after = (k + 1) % polygon.size();
    append(grid, polygon[before], polygon[k], polygon[after], triangles);
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
  }
  append(grid, polygon[0], polygon[1], polygon[2], triangles);
}

}  // namespace saddle
