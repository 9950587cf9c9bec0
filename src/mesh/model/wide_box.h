// A box of floats around a box of doubles: for tests that many boxes pass through, where memory is
// what takes time.
#pragma once

#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/bounds.h"

namespace saddle {

/// Half the memory of a box, and wider than it: a point outside of it is outside of the box.
class WideBox {
 public:
  /// Uninitialised.
  WideBox() = default;
  /// Numbers beyond the largest float become that or infinity, whichever is outside.
  explicit WideBox(const Bounds& box) {
    using Float = std::numeric_limits<float>;
    // Twice the rounding error of a float, and the least normal float where floats lose digits.
    const dvec3 margin =
        double{Float::epsilon()} * glm::max(glm::abs(box.low), glm::abs(box.high)) +
        double{Float::min()};
    low_ = glm::min(box.low - margin, dvec3(Float::max()));
    high_ = glm::max(box.high + margin, dvec3(Float::lowest()));
  }
  /// Around two boxes.
  WideBox(const WideBox& a, const WideBox& b)
      : low_(glm::min(a.low_, b.low_)), high_(glm::max(a.high_, b.high_)) {}
  Bounds bounds() const { return {low_, high_}; }
  /// The square of the distance of a point from the box: from its nearest point there. GCC compiles
  /// the largest of the distances from its faces to branches, which are often mispredicted.
  double square_distance(const dvec3& p) const {
    const dvec3 way = p - glm::clamp(p, dvec3(low_), dvec3(high_));
    return glm::dot(way, way);
  }

 private:
  glm::vec3 low_;
  glm::vec3 high_;
};

}  // namespace saddle
