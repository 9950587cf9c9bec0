// The vector types of the whole program: GLM's, in double; floats exist only on the way to the GPU.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace saddle {

using glm::dvec2;
using glm::dvec3;

}  // namespace saddle
