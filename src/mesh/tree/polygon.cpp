#include "mesh/tree/polygon.h"

#include <algorithm>
#include <optional>
#include <tuple>
#include <utility>

#include "mesh/grid/triangulate.h"

namespace saddle {

namespace {

/// Twice the area of a triangle in units of the cell tree; exact for whole places, which are less
/// than 2^17 apart.
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

/// Twice an area that corners on one straight side may have: places of cuts are rounded.
double rounding_of_area(std::span<const PolygonCorner> polygon) {
  double reach = 0;
  double rounding = 0;
  for (const PolygonCorner& corner : polygon) {
    const dvec2 way = glm::abs(corner.place - polygon[0].place);
    reach = std::max({reach, way.x, way.y});
    rounding = std::max(rounding, rounding_of_place(corner.place));
  }
  return 2 * rounding * reach;
}

/// How far from a chord a corner may be, in chords, that is on it but for rounding.
constexpr double kOnChord = 1e-12;

/// Two points of the surface, in order.
using PointPair = std::pair<std::uint32_t, std::uint32_t>;

PointPair points_of(const Mesh& mesh, const PolygonCorner& a, const PolygonCorner& b) {
  return std::minmax(mesh.point[a.corner], mesh.point[b.corner]);
}

/// The sides of a polygon that meets itself, as where an edge of the domain is folded in it: a
/// chord beside a side of the same points would be an edge of four triangles. None of others:
/// neighbours that are one point, as at a pole, are no meeting.
std::vector<PointPair> sides_that_meet(const Mesh& mesh, std::span<const PolygonCorner> polygon) {
  std::vector<PointPair> sides;
  std::vector<std::uint32_t> points;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const PointPair side = points_of(mesh, polygon[k], polygon[(k + 1) % polygon.size()]);
    if (side.first == side.second) continue;
    sides.push_back(side);
    points.push_back(mesh.point[polygon[k].corner]);
  }
  std::ranges::sort(points);
  const bool meets = std::ranges::adjacent_find(points) != points.end();
  return meets ? sides : std::vector<PointPair>();
}

/// Whether a corner lies on an ear's chord, be it the tip: the ear or what is left would have a
/// side without a neighbour, since triangles without area are left out. So at the apex of a cone.
bool passes_over_corner(const Grid& grid, std::span<const PolygonCorner> polygon, std::size_t tip) {
  const std::size_t count = polygon.size();
  const dvec3 from = grid.local(polygon[(tip + count - 1) % count].corner);
  const dvec3 chord = grid.local(polygon[(tip + 1) % count].corner) - from;
  const double square = glm::dot(chord, chord);
  for (const PolygonCorner& corner : polygon) {
    const dvec3 way = grid.local(corner.corner) - from;
    const double along = glm::dot(way, chord);
    const dvec3 off = glm::cross(way, chord);
    if (along > 0 && along < square &&
        glm::dot(off, off) <= kOnChord * kOnChord * square * square) {
      return true;
    }
  }
  return false;
}

/// Whether two corners are one point.
bool has_pole(const Mesh& mesh, std::span<const PolygonCorner> polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    for (std::size_t other = 0; other < k; ++other) {
      if (mesh.point[polygon[k].corner] == mesh.point[polygon[other].corner]) return true;
    }
  }
  return false;
}

/// Whether the triangle at an ear's tip faces away from the front that the normals of its corners
/// tell, as where the polygon is bent so that the tip is beyond the chord.
bool faces_away(const Grid& grid, const PolygonCorner& a, const PolygonCorner& tip,
                const PolygonCorner& b) {
  const auto& [position, normal] = std::tie(grid.mesh.position, grid.mesh.normal);
  const dvec3& first = position[a.corner];
  const dvec3 area = glm::cross(position[tip.corner] - first, position[b.corner] - first);
  const double front = glm::dot(area, normal[a.corner] + normal[tip.corner] + normal[b.corner]);
  return grid.mirrored ? front > 0 : front < 0;
}

/// A triangle that may be cut off a polygon, and how good its chord is.
struct Ear {
  std::size_t tip;
  double sagitta;  ///< of the arc above the chord
  double length;   ///< of the chord, squared
  int flaws = 0;

  bool is_nearer(const Ear& other) const {
    if (is_smaller(sagitta, other.sagitta)) return true;
    return !is_smaller(other.sagitta, sagitta) && is_smaller(length, other.length);
  }
};

/// What an ear is spoiled by, the worst counting most: its chord is one of `taken`, or passes over
/// a corner; it faces away.
int flaws_of(const Grid& grid, std::span<const PolygonCorner> polygon, std::size_t tip,
             bool is_at_pole, std::span<const PointPair> taken) {
  const PolygonCorner& before = polygon[(tip + polygon.size() - 1) % polygon.size()];
  const PolygonCorner& after = polygon[(tip + 1) % polygon.size()];
  const bool is_taken =
      (!taken.empty() && std::ranges::count(taken, points_of(grid.mesh, before, after)) > 0) ||
      (is_at_pole && passes_over_corner(grid, polygon, tip));
  return (is_taken ? 2 : 0) + (faces_away(grid, before, polygon[tip], after) ? 1 : 0);
}

/// The ear to cut off: its tip's index. It is the one of those with the fewest flaws whose chord is
/// nearest to the surface.
std::size_t best_ear(const Grid& grid, std::span<const PolygonCorner> polygon, bool is_at_pole,
                     std::span<const PointPair> taken) {
  const double whole = doubled_area(polygon);
  const double rounding = rounding_of_area(polygon);
  const Mesh& mesh = grid.mesh;
  std::optional<Ear> best;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const PolygonCorner& before = polygon[(k + polygon.size() - 1) % polygon.size()];
    const PolygonCorner& after = polygon[(k + 1) % polygon.size()];
    const double area = doubled_area(before.place, polygon[k].place, after.place);
    // What is left must have area too: corners on one straight side are no polygon.
    if (area <= rounding || area >= whole - rounding) continue;
    const dvec3& a = mesh.position[before.corner];
    const dvec3& b = mesh.position[after.corner];
    Ear ear{k, sagitta(a, mesh.normal[before.corner], b, mesh.normal[after.corner]),
            glm::dot(b - a, b - a)};
    const bool is_nearer = !best || ear.is_nearer(*best);
    if (!is_nearer && best->flaws == 0) continue;
    ear.flaws = flaws_of(grid, polygon, k, is_at_pole, taken);
    if (!best || ear.flaws < best->flaws || (ear.flaws == best->flaws && is_nearer)) best = ear;
  }
  return best ? best->tip : 0;
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
  const bool is_at_pole = polygon.size() > 3 && has_pole(grid.mesh, polygon);
  const std::vector<PointPair> taken =
      is_at_pole ? sides_that_meet(grid.mesh, polygon) : std::vector<PointPair>();
  while (polygon.size() > 3) {
    const std::size_t k = best_ear(grid, polygon, is_at_pole, taken);
    const std::size_t before = (k + polygon.size() - 1) % polygon.size();
    const std::size_t after = (k + 1) % polygon.size();
    append(grid, polygon[before], polygon[k], polygon[after], triangles);
    polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(k));
  }
  append(grid, polygon[0], polygon[1], polygon[2], triangles);
}

}  // namespace saddle
