// The vector types of the whole program: GLM's, in double; floats exist only on the way to the GPU.
#pragma once

#include <cmath>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace saddle {

using glm::dvec2;
using glm::dvec3;

/// Whether no component is infinite or NaN.
inline bool is_finite(const dvec3& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

}  // namespace saddle
