// The vector types of the whole program: GLM's, in double. Floats exist on the way to the GPU and
// in WideBox.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

namespace saddle {

using glm::dvec2;
using glm::dvec3;

/// The angle between two vectors of any length, 0 to 180 degrees, to all digits at both ends.
inline double degrees_between(const dvec3& a, const dvec3& b) {
  constexpr double kDegrees = 57.29577951308232087679815;
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * kDegrees;
}

/// The cross product of vectors in a plane: the signed area of their parallelogram.
inline double cross(const dvec2& a, const dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

inline double least_of(const dvec3& a) {
  return std::fmin(std::fmin(a.x, a.y), a.z);
}
inline double largest_of(const dvec3& a) {
  return std::fmax(std::fmax(a.x, a.y), a.z);
}

/// Whether no component is infinite or NaN.
inline bool is_finite(const dvec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace saddle
