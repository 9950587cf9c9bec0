// Distances from segments of lines in space.
#pragma once

#include <algorithm>

#include "base/vec.h"

namespace saddle {

/// The point of a segment that is nearest to a position.
struct NearestOnSegment {
  double share;  ///< of the way from a to b
  dvec3 offset;  ///< from the point to the position
};
inline NearestOnSegment nearest_on_segment(const dvec3& a, const dvec3& b, const dvec3& p) {
  const dvec3 way = b - a;
  const double square = glm::dot(way, way);
  const double share = square > 0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0;
  return {share, p - (a + share * way)};
}

inline double distance_from_segment(const dvec3& a, const dvec3& b, const dvec3& p) {
  return glm::length(nearest_on_segment(a, b, p).offset);
}

}  // namespace saddle
