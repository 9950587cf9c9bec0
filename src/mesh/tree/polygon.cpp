#include "mesh/tree/polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/triangulate.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Two points of the surface, in order.
using PointPair = std::pair<std::uint32_t, std::uint32_t>;

PointPair points_of(const Mesh& mesh, const PolygonCorner& a, const PolygonCorner& b) {
  return std::minmax(mesh.point[a.corner], mesh.point[b.corner]);
}

/// The sides of a polygon that touches itself, as at a folded edge of the domain; none of another
/// polygon. A chord between the same two points as a side would be an edge of four triangles.
/// Neighbours that are one point, as at a pole, do not count.
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

/// Whether a corner, possibly the tip, lies on the chord of an ear, as at the apex of a cone. The
/// triangle without area would be left out, and leave an edge without a neighbour.
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
        glm::dot(off, off) <= kRoundingOfSums * kRoundingOfSums * square * square) {
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

/// Whether an ear faces against the normals of its corners, as where a bent polygon has its tip
/// beyond the chord.
bool faces_away(const Grid& grid, const PolygonCorner& a, const PolygonCorner& tip,
                const PolygonCorner& b) {
  const auto& [position, normal] = std::tie(grid.mesh.position, grid.mesh.normal);
  const dvec3& first = position[a.corner];
  const dvec3 area = glm::cross(position[tip.corner] - first, position[b.corner] - first);
  const double front = glm::dot(area, normal[a.corner] + normal[tip.corner] + normal[b.corner]);
  return grid.mirrored ? front > 0 : front < 0;
}

/// How far the surface's arc between two corners strays from its chord, by the corners' normals. A
/// chord from the foot of a steep wall to its top has an S above it, whose normals may be parallel:
/// its sagitta is 0. A cubic arc that leaves its chord and returns to it at the slope s is
/// sqrt(3) / 18 s high, in lengths of the chord.
double height_of_arc(const Mesh& mesh, std::uint32_t a, std::uint32_t b) {
  const dvec3& from = mesh.position[a];
  const dvec3& to = mesh.position[b];
  const dvec3 mean = 0.5 * (mesh.normal[a] + mesh.normal[b]);
  const double height_of_s = std::numbers::sqrt3 / 18 * std::fabs(glm::dot(mean, to - from));
  return sagitta(from, mesh.normal[a], to, mesh.normal[b]) + height_of_s;
}

/// A triangle that may be cut off a polygon, and the quality of its chord.
struct Ear {
  std::size_t tip;
  double height;  ///< of the arc above the chord
  double length;  ///< of the chord, squared
  int flaws = 0;

  bool is_nearer(const Ear& other) const {
    if (is_smaller(height, other.height)) return true;
    return !is_smaller(other.height, height) && is_smaller(length, other.length);
  }
};

/// The penalty of an ear: 2 if its chord is one of `taken` or passes over a corner, 1 if it faces
/// away.
int flaws_of(const Grid& grid, std::span<const PolygonCorner> polygon, std::size_t tip,
             bool is_at_pole, std::span<const PointPair> taken) {
  const PolygonCorner& before = polygon[(tip + polygon.size() - 1) % polygon.size()];
  const PolygonCorner& after = polygon[(tip + 1) % polygon.size()];
  const bool is_taken =
      (!taken.empty() && std::ranges::count(taken, points_of(grid.mesh, before, after)) > 0) ||
      (is_at_pole && passes_over_corner(grid, polygon, tip));
  return (is_taken ? 2 : 0) + (faces_away(grid, before, polygon[tip], after) ? 1 : 0);
}

/// Whether a polygon has a corner at which it turns clockwise, as at an inner vertex.
bool is_concave(std::span<const PolygonCorner> polygon, double rounding) {
  const std::size_t count = polygon.size();
  for (std::size_t k = 0; k < count; ++k) {
    const double area = doubled_area(polygon[(k + count - 1) % count].place, polygon[k].place,
                                     polygon[(k + 1) % count].place);
    if (area < -rounding) return true;
  }
  return false;
}

/// Whether an ear holds another corner of its polygon, which cannot be if that is convex.
bool holds_corner(std::span<const PolygonCorner> polygon, std::size_t tip) {
  const std::size_t count = polygon.size();
  const std::size_t before = (tip + count - 1) % count;
  const std::size_t after = (tip + 1) % count;
  const dvec2& a = polygon[before].place;
  const dvec2& b = polygon[tip].place;
  const dvec2& c = polygon[after].place;
  for (std::size_t k = 0; k < count; ++k) {
    if (k == before || k == tip || k == after) continue;
    const dvec2& p = polygon[k].place;
    if (p == a || p == b || p == c) continue;
    if (doubled_area(a, b, p) >= 0 && doubled_area(b, c, p) >= 0 && doubled_area(c, a, p) >= 0) {
      return true;
    }
  }
  return false;
}

/// Bound on twice the area of a polygon of corners on one straight side. Its cause is the rounding
/// of features' places.
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

/// The index of the best ear's tip: the fewest flaws, then the chord nearest to the surface.
std::size_t best_ear(const Grid& grid, std::span<const PolygonCorner> polygon, bool is_at_pole,
                     std::span<const PointPair> taken) {
  const double whole = doubled_area_of(polygon);
  const double rounding = rounding_of_area(polygon);
  const bool concave = is_concave(polygon, rounding);
  const Mesh& mesh = grid.mesh;
  std::optional<Ear> best;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const PolygonCorner& before = polygon[(k + polygon.size() - 1) % polygon.size()];
    const PolygonCorner& after = polygon[(k + 1) % polygon.size()];
    const double area = doubled_area(before.place, polygon[k].place, after.place);
    // The rest must have an area, too: corners on one straight side are no polygon.
    if (area <= rounding || (!concave && area >= whole - rounding)) continue;
    if (concave && holds_corner(polygon, k)) continue;
    const dvec3& a = mesh.position[before.corner];
    const dvec3& b = mesh.position[after.corner];
    Ear ear{k, height_of_arc(mesh, before.corner, after.corner), glm::dot(b - a, b - a)};
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

dvec2 border_of_square(const dvec2& from, const dvec2& way) {
  double steps = std::numeric_limits<double>::infinity();
  int axis = -1;
  for (int k = 0; k < 2; ++k) {
    const double room = way[k] > 0 ? 1 - from[k] : from[k];
    const double until = room / std::fabs(way[k]);
    if (way[k] == 0 || until >= steps) continue;
    steps = until;
    axis = k;
  }
  dvec2 border = from + steps * way;
  // The surface may end on a side of its leaf, and be defined one rounding before.
  if (axis >= 0) border[axis] = way[axis] > 0 ? 1 : 0;
  return border;
}

double doubled_area_of(std::span<const PolygonCorner> polygon) {
  double sum = 0;
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    sum += doubled_area(polygon[0].place, polygon[k].place, polygon[k + 1].place);
  }
  return sum;
}

bool has_area(std::span<const PolygonCorner> polygon) {
  return doubled_area_of(polygon) > rounding_of_area(polygon);
}

void cut_off_pinched(double same, Polygon& polygon, std::vector<Polygon>& others) {
  for (std::size_t j = 2; j < polygon.size(); ++j) {
    for (std::size_t i = 0; i + 1 < j; ++i) {
      if (glm::distance(polygon[i].place, polygon[j].place) > same) continue;
      const auto first = polygon.begin() + static_cast<std::ptrdiff_t>(i);
      const auto last = polygon.begin() + static_cast<std::ptrdiff_t>(j);
      Polygon cut_off(first, last);
      Polygon rest(polygon.begin(), first + 1);
      rest.insert(rest.end(), last + 1, polygon.end());
      if (!has_area(cut_off) || !has_area(rest)) continue;
      others.push_back(std::move(cut_off));
      polygon = std::move(rest);
      j = i;  // those after it are new here
      break;
    }
  }
}

std::vector<Polygon> strips_between(std::span<const PolygonCorner> a,
                                    std::span<const PolygonCorner> b) {
  std::vector<Polygon> strips;
  const auto share = [](std::span<const PolygonCorner> on, std::size_t k) {
    return glm::distance(on[k].place, on.front().place) /
           glm::distance(on.back().place, on.front().place);
  };
  std::size_t i = 0;         // segments of a that are done
  std::size_t j = b.size();  // corners of b that are not
  while (i < a.size() || j > 0) {
    // The next ends of segments, as shares from the first corner of a and the last of b.
    const double next_a = i < a.size() ? share(a, i + 1) : kInfinity;
    const double next_b = j > 0 ? 1 - share(b, j - 2) : kInfinity;
    const bool are_alike = a.size() == b.size();
    const bool takes_a = i < a.size() && (are_alike || next_a <= next_b);
    const bool takes_b = j > 0 && (are_alike || next_b <= next_a);
    Polygon strip = {a[std::min(i, a.size() - 1)]};
    if (takes_a) strip.push_back(a[i + 1]);
    if (takes_b) strip.push_back(b[j - 2]);
    strip.push_back(b[std::max(j, std::size_t{1}) - 1]);
    strips.push_back(std::move(strip));
    if (takes_a) i += 2;
    if (takes_b) j -= 2;
  }
  return strips;
}

void triangulate_polygon(const Grid& grid, Polygon polygon, Array<Triangle>& triangles) {
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
