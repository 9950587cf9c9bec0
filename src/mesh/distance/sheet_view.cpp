#include "mesh/distance/sheet_view.h"

#include <algorithm>
#include <cmath>

#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// The part of a line, from 0 to 1, within a triangle.
std::array<double, 2> part_in(const std::array<dvec2, 3>& triangle, const Line& line) {
  std::array<double, 2> part = {0, 1};
  for (std::size_t k = 0; k < 3; ++k) {
    const dvec2 side = triangle[(k + 1) % 3] - triangle[k];
    const double first = cross(side, line[0] - triangle[k]);
    const double last = cross(side, line[1] - triangle[k]);
    if (first < 0 && last < 0) return {1, 0};
    if (first < 0) part[0] = std::max(part[0], first / (first - last));
    if (last < 0) part[1] = std::min(part[1], first / (first - last));
  }
  return part;
}

/// Whether triangles cover a line from a place within one of them. A gap of kSame sides of the leaf
/// between two triangles is rounding.
bool cover(std::span<const PlacedTriangle> triangles, const Line& line) {
  const double gap = kSame / glm::distance(line[0], line[1]);
  double covered = 0;
  for (bool has_grown = true; has_grown && covered < 1 - gap;) {
    has_grown = false;
    for (const PlacedTriangle& t : triangles) {
      const auto [first, last] = part_in(t.places, line);
      if (first > covered + gap || !(last > covered + gap)) continue;
      covered = last;
      has_grown = true;
    }
  }
  return covered >= 1 - gap;
}

/// A height above a share of a chord this near to an end is that of an edge which begins beside the
/// chord, and no part of a straight one from the end.
constexpr double kNextToEnd = 1.0 / 64;

/// The largest distance of a parabola through three heights between the outer two.
double top_of_parabola(const Height& a, const Height& b, const Height& c) {
  const double before = (b.distance - a.distance) / (b.share - a.share);
  const double after = (c.distance - b.distance) / (c.share - b.share);
  const double bend = (after - before) / (c.share - a.share);
  if (!(bend < 0)) return 0;
  const double slope = before + bend * (b.share - a.share);  // at b
  const double step = std::clamp(-slope / (2 * bend), a.share - b.share, c.share - b.share);
  return b.distance + step * (slope + bend * step);
}

}  // namespace

CellTriangles::CellTriangles(std::span<const Triangle> triangles) : triangles_(triangles) {
  sides_.reserve(3 * triangles.size());
  for (std::uint32_t number = 0; number < triangles.size(); ++number) {
    const Triangle& t = triangles[number];
    for (std::size_t k = 0; k < 3; ++k) sides_.push_back({{t[k], t[(k + 1) % 3]}, number});
  }
  std::ranges::stable_sort(sides_, {}, &NumberedSide::ends);
}

std::span<const CellTriangles::NumberedSide> CellTriangles::with_side(std::uint32_t a,
                                                                      std::uint32_t b) const {
  const std::array ends = {a, b};
  return {std::ranges::lower_bound(sides_, ends, {}, &NumberedSide::ends),
          std::ranges::upper_bound(sides_, ends, {}, &NumberedSide::ends)};
}

std::vector<Triangle> CellTriangles::connected_to(std::uint32_t number) const {
  std::vector<std::uint32_t> connected = {number};
  std::vector<bool> is_connected(triangles_.size(), false);
  is_connected[number] = true;
  for (std::size_t next = 0; next < connected.size(); ++next) {
    const Triangle& t = triangles_[connected[next]];
    const std::size_t first = connected.size();
    for (std::size_t k = 0; k < 3; ++k) {
      for (const NumberedSide& side : with_side(t[(k + 1) % 3], t[k])) {
        if (is_connected[side.triangle]) continue;
        is_connected[side.triangle] = true;
        connected.push_back(side.triangle);
      }
    }
    std::sort(connected.begin() + static_cast<std::ptrdiff_t>(first), connected.end());
  }
  std::vector<Triangle> sheet;
  sheet.reserve(connected.size());
  for (const std::uint32_t triangle : connected) sheet.push_back(triangles_[triangle]);
  return sheet;
}

std::uint32_t corner_across(const Grid& grid, const Chord& chord, double share, const dvec2& at,
                            std::uint32_t opposite, std::span<const PlacedTriangle> triangles) {
  const dvec3 along = grid.local(chord[1]) - grid.local(chord[0]);
  const dvec3 middle = grid.local(chord[0]) + share * along;
  std::uint32_t best = opposite;
  double sine = 0;
  for (const PlacedTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 way = grid.local(t.corners[k]) - middle;
      const double square = glm::dot(way, way);
      if (t.corners[k] == chord[0] || t.corners[k] == chord[1] || square == 0) continue;
      const double own = glm::length(glm::cross(along, way)) / std::sqrt(square);
      if (!(own > sine) || !cover(triangles, {at, t.places[k]})) continue;
      best = t.corners[k];
      sine = own;
    }
  }
  return best;
}

double height_of_roof(const Height& first, const Height& last) {
  if (!(first.share > kNextToEnd && last.share < 1 - kNextToEnd)) return 0;
  const double rise = first.distance / first.share;
  const double fall = last.distance / (1 - last.share);
  return rise > 0 && fall > 0 ? rise * fall / (rise + fall) : 0;
}

double predicted_distance(std::array<Height, 3> heights) {
  std::ranges::sort(heights, {}, &Height::share);
  const auto& [a, b, c] = heights;
  // Half as far as the places of kAlongLine.
  const double apart = 0.5 * kAlongLine.front();
  const bool are_apart = b.share - a.share > apart && c.share - b.share > apart;
  if (!(a.share > 0 && c.share < 1 && are_apart)) return 0;
  const double at_first = a.distance + (a.distance - b.distance) * a.share / (b.share - a.share);
  const double at_last =
      c.distance + (c.distance - b.distance) * (1 - c.share) / (c.share - b.share);
  // A place next to an end says nothing of the slope there.
  const double before = a.share > apart ? top_of_parabola({0, 0}, a, b) : 0;
  const double after = 1 - c.share > apart ? top_of_parabola(b, c, {1, 0}) : 0;
  return std::max({at_first, at_last, before, top_of_parabola(a, b, c), after});
}

double supported_distance(double predicted, double farthest, double allowed) {
  return std::min(predicted, std::max(farthest / (1 - kAlongLine.front()), allowed));
}

}  // namespace saddle
