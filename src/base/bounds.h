// Boxes around points.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "base/vec.h"

namespace saddle {

/// An axis-aligned box; empty until it holds a point.
struct Bounds {
  dvec3 low{std::numeric_limits<double>::infinity()};
  dvec3 high{-std::numeric_limits<double>::infinity()};

  bool operator==(const Bounds&) const = default;
  bool empty() const { return low.x > high.x; }
  void add(const dvec3& p) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  void add(const Bounds& b) {
    low = glm::min(low, b.low);
    high = glm::max(high, b.high);
  }
  dvec3 centre() const { return 0.5 * low + 0.5 * high; }
  dvec3 size() const { return high - low; }
  /// Corner k is at the high end of an axis where that axis's bit of k is set, x first.
  std::array<dvec3, 8> corners() const {
    std::array<dvec3, 8> result;
    for (std::size_t k = 0; k < result.size(); ++k) {
      result[k] = {(k & 1) != 0 ? high.x : low.x, (k & 2) != 0 ? high.y : low.y,
                   (k & 4) != 0 ? high.z : low.z};
    }
    return result;
  }
  /// Whether a point is in the box or on its faces.
  bool contains(const dvec3& p) const {
    return glm::all(glm::lessThanEqual(low, p)) && glm::all(glm::lessThanEqual(p, high));
  }
  double diagonal() const {
    if (empty()) return 0;
    const dvec3 s = size();
    return std::hypot(s.x, s.y, s.z);  // squares of lengths overflow and vanish
  }
};

/// The box around some points.
inline Bounds bounds_of(std::span<const dvec3> points) {
  Bounds bounds;
  for (const dvec3& p : points) bounds.add(p);
  return bounds;
}

/// Factors that give each coordinate an extent of 1, or leave it alone where it has none.
inline dvec3 axis_scale(const Bounds& bounds) {
  dvec3 scale(1);
  for (int k = 0; k < 3; ++k) {
    if (std::isnormal(1 / bounds.size()[k])) scale[k] = 1 / bounds.size()[k];
  }
  return scale;
}

}  // namespace saddle
