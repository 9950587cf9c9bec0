#include "mesh/distance/overlay.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/vec.h"
#include "mesh/model/segment.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// A plane with coordinates in which one triangle has the corners (0, 0), (1, 0) and (0, 1).
class PlaneOfTriangle {
 public:
  explicit PlaneOfTriangle(const std::array<dvec3, 3>& corners)
      : origin_(corners[0]), b_(corners[1] - origin_), c_(corners[2] - origin_) {
    const dvec3 area = glm::cross(b_, c_);
    const double length = glm::length(area);
    has_area_ = length > kSame * glm::length(b_) * glm::length(c_);
    up_ = area / length;
    to_b_ = glm::cross(c_, up_) / length;
    to_c_ = glm::cross(up_, b_) / length;
  }

  /// Whether the triangle is more than a line but for rounding. Only then the plane may be used.
  bool has_area() const { return has_area_; }

  /// Coordinates in the plane, and the height above it.
  dvec3 to_plane(const dvec3& position) const {
    const dvec3 way = position - origin_;
    return {glm::dot(way, to_b_), glm::dot(way, to_c_), glm::dot(way, up_)};
  }
  dvec3 position_at(const dvec2& place) const { return origin_ + place.x * b_ + place.y * c_; }

 private:
  dvec3 origin_, b_, c_, up_, to_b_, to_c_;
  bool has_area_;
};

/// The rest of the triangle after up to three cuts, in the coordinates of its plane. A cut adds a
/// corner, or where roundings bend sides at most half as many corners as there are: 9 in all.
struct Part {
  std::array<dvec2, 9> corner = {dvec2(0, 0), dvec2(1, 0), dvec2(0, 1)};
  std::size_t count = 3;

  std::span<const dvec2> corners() const { return std::span(corner).first(count); }
};

/// The part of a convex polygon to the left of a line.
Part left_of(const dvec2& from, const dvec2& to, const Part& part) {
  Part left;
  left.count = 0;
  std::array<double, 9> height;
  for (std::size_t k = 0; k < part.count; ++k) height[k] = cross(to - from, part.corner[k] - from);
  for (std::size_t k = 0; k < part.count; ++k) {
    const std::size_t next = k + 1 == part.count ? 0 : k + 1;
    if (height[k] >= 0) left.corner[left.count++] = part.corner[k];
    if (std::min(height[k], height[next]) < 0 && std::max(height[k], height[next]) > 0) {
      const double share = height[k] / (height[k] - height[next]);
      left.corner[left.count++] = glm::mix(part.corner[k], part.corner[next], share);
    }
  }
  return left;
}

/// A triangle of the mesh, projected onto the plane.
class Projected {
 public:
  Projected(const PlaneOfTriangle& plane, const std::array<dvec3, 3>& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      const dvec3 place = plane.to_plane(corners[k]);
      at_[k] = dvec2(place);
      height_[k] = place.z;
    }
    twice_ = cross(at_[1] - at_[0], at_[2] - at_[0]);
  }

  /// Twice its area: less than 0 if it lies the other way up.
  double twice_area() const { return twice_; }

  /// The part of the plane's triangle that is over this one.
  Part overlap() const {
    Part part;
    for (std::size_t k = 0; k < 3 && part.count > 0; ++k) part = beside(k, part, twice_ > 0);
    return part;
  }
  /// The part of the plane's triangle beyond the side from corner k to the next.
  Part beyond(std::size_t k) const { return beside(k, Part(), twice_ < 0); }

  /// Its height above the plane, straight above a place.
  double height_at(const dvec2& place) const {
    const dvec2 way = place - at_[0];
    const double b = cross(way, at_[2] - at_[0]) / twice_;
    const double c = cross(at_[1] - at_[0], way) / twice_;
    return height_[0] + b * (height_[1] - height_[0]) + c * (height_[2] - height_[0]);
  }

 private:
  Part beside(std::size_t k, const Part& part, bool is_left) const {
    const dvec2& from = at_[k];
    const dvec2& to = at_[(k + 1) % 3];
    return is_left ? left_of(from, to, part) : left_of(to, from, part);
  }

  std::array<dvec2, 3> at_;
  std::array<double, 3> height_;
  double twice_;
};

std::ptrdiff_t count_sides(std::span<const Triangle> triangles, std::uint32_t from,
                           std::uint32_t to) {
  return std::ranges::count_if(triangles, [&](const Triangle& t) {
    return (t[0] == from && t[1] == to) || (t[1] == from && t[2] == to) ||
           (t[2] == from && t[0] == to);
  });
}

}  // namespace

// If all triangles lie the same way up, what is over none of them is beyond a side that no two of
// them share: their outline winds around all else. Heights are linear over each part, and distances
// from a side convex: both are largest at the corners.
bool is_over(const std::array<dvec3, 3>& corners, const Grid& grid,
             std::span<const Triangle> triangles, double most) {
  const double scale = grid.local_scale;
  const PlaneOfTriangle plane({scale * corners[0], scale * corners[1], scale * corners[2]});
  if (!plane.has_area() || triangles.empty()) return false;
  const double most_local = scale * most;
  std::optional<bool> is_upward;
  for (const Triangle& t : triangles) {
    const Projected own(plane, {grid.local(t[0]), grid.local(t[1]), grid.local(t[2])});
    const double area = own.twice_area();
    if (!(area != 0) || is_upward.value_or(area > 0) != (area > 0)) return false;  // true for NaN
    is_upward = area > 0;
    const Part overlap = own.overlap();
    for (const dvec2& place : overlap.corners()) {
      if (!(std::fabs(own.height_at(place)) <= most_local)) return false;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      if (count_sides(triangles, to, from) == 1 && count_sides(triangles, from, to) == 1) continue;
      const Part beyond = own.beyond(k);
      for (const dvec2& place : beyond.corners()) {
        const double distance =
            distance_from_segment(grid.local(from), grid.local(to), plane.position_at(place));
        if (!(distance <= most_local)) return false;
      }
    }
  }
  return true;
}

}  // namespace saddle
