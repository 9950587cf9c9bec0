#include "mesh/proof/box_bounds.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "mesh/model/tolerances.h"
#include "surface/surface_enclosure.h"

namespace saddle {
namespace {

/// A box is measured in up to 16 parts if its bounds are narrow enough for that.
constexpr std::uint32_t kMostMeasured = 16;
/// Grids of points that measure a box: 0 cells along an axis stand for the middle of its range. The
/// middle alone needs bounds of first derivatives, or of positions; cells those of second ones.
constexpr std::array<std::array<std::uint32_t, 2>, 4> kFewestCells = {
    {{0, 0}, {0, 1}, {1, 0}, {1, 1}}};

double magnitude(const Interval& a) {
  return std::max(std::fabs(a.low), std::fabs(a.high));
}
double length(std::span<const Interval> vector) {
  return std::hypot(magnitude(vector[0]), magnitude(vector[1]), magnitude(vector[2]));
}
bool are_defined(std::span<const Interval> bounds) {
  return std::ranges::all_of(bounds, [](const Interval& a) { return a.defined == Defined::Yes; });
}

}  // namespace

BoxBounds::BoxBounds(std::span<const Interval> bounds) {
  for (const Interval& a : bounds.first(3)) {
    is_undefined = is_undefined || a.defined == Defined::No;
    if (a.defined != Defined::Yes) {
      broken = GapReason::Undefined;
    } else if (!a.continuous && !broken) {
      broken = GapReason::Discontinuous;
    }
  }
  if (is_undefined) return;
  hull = hull_of(bounds);
  const auto tangents = bounds.subspan(3, 6);
  const auto length_of = [](std::span<const Interval> vector) {
    return are_defined(vector) ? length(vector) : kInfinity;
  };
  if (!broken) slope = {length_of(tangents.first(3)), length_of(tangents.last(3))};
  const auto are_continuous = [](std::span<const Interval> vector) {
    return std::ranges::all_of(vector, [](const Interval& a) { return a.continuous; });
  };
  may_crease = std::isfinite(slope.x + slope.y) && !are_continuous(tangents);
  if (broken) return;
  const bool along_u = are_continuous(tangents.first(3));
  const bool along_v = are_continuous(tangents.last(3));
  is_smooth = along_u && along_v && are_defined(bounds.subspan(3));
  const auto second = bounds.subspan(9);
  if (along_u) bend.x = length_of(second.first(3));
  if (along_u && along_v) bend.y = length_of(second.subspan(3, 3));
  if (along_v) bend.z = length_of(second.last(3));
}

double BoxBounds::arc(const dvec2& size) const {
  return (size.x * size.x * bend.x + 2 * size.x * size.y * bend.y + size.y * size.y * bend.z) / 8;
}

double BoxBounds::reach(const dvec2& size, const std::array<std::uint32_t, 2>& cells) const {
  const dvec2 by_slope = 0.5 * size * slope;
  const auto by_bend = [&size, &cells](int axis, double of_axis) {
    const double step = size[axis] / cells[static_cast<std::size_t>(axis)];
    return step * step * of_axis / 8;
  };
  if (cells[0] > 0 && cells[1] > 0) return arc(size / dvec2(cells[0], cells[1]));
  if (cells[0] > 0) return by_bend(0, bend.x) + by_slope.y;
  if (cells[1] > 0) return by_bend(1, bend.z) + by_slope.x;
  return by_slope.x + by_slope.y;
}

std::optional<std::array<std::uint32_t, 2>> BoxBounds::cells_within(const dvec2& size,
                                                                    double allowed) const {
  for (std::array<std::uint32_t, 2> cells : kFewestCells) {
    while (true) {
      if (reach(size, cells) <= allowed) return cells;
      const dvec2 each = glm::max(dvec2(cells[0], cells[1]), dvec2(1));
      if (cells == kFewestCells.front() || each.x * each.y >= kMostMeasured) break;
      const dvec2 step = size / each;
      const bool is_along_u = bend.x * step.x * step.x >= bend.z * step.y * step.y;
      cells[cells[1] == 0 || (cells[0] > 0 && is_along_u) ? 0 : 1] *= 2;
    }
  }
  return std::nullopt;
}

dvec2 BoxBounds::contributions(const dvec2& size) const {
  return glm::min(0.5 * size * slope, size * size * dvec2(bend.x, bend.z) / 8.0);
}

BoundedPart farthest_part(const ParameterBox& whole, double tolerance,
                          const std::function<BoxBounds(const ParameterBox&)>& bounds_over) {
  const dvec3 corner = bounds_over({whole.low, whole.low}).hull.low;
  BoundedPart part{whole, bounds_over(whole)};
  for (int depth = 0; depth < kHalvingsToNearly && !part.bounds.is_undefined; ++depth) {
    const dvec2 way = part.bounds.slope * part.box.size();
    const bool is_known = std::isfinite(way.x + way.y) && way.x != way.y;
    const auto halves = halves_of(part.box, is_known ? (way.x > way.y ? 0 : 1) : depth % 2);
    const BoxBounds first = bounds_over(halves[0]);
    const BoxBounds second = bounds_over(halves[1]);
    const bool is_second = second.farthest(corner) > first.farthest(corner);
    part = {halves[is_second ? 1 : 0], is_second ? second : first};
    if (part.bounds.extent() <= tolerance) break;
  }
  return part;
}

}  // namespace saddle
