// Which parts of the surface's shaders a scene needs, and their text with just those.
#pragma once

#include <string>
#include <vector>

#include "render/shading/shader_needs.h"
#include "render/shading/shader_text.h"

namespace saddle {

/// The files of shaders/ with the parts that are needed, and no other.
ShaderText assemble_surface_shader(const ShaderNeeds& needs);

/// The parts that are left out, each with its reason: "no spot light: no cone test".
std::vector<std::string> parts_left_out(const ShaderNeeds& needs);

}  // namespace saddle
