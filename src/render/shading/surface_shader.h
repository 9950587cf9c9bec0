// Which parts of the surface's shaders a scene needs, and their text with just those.
#pragma once

#include "render/shading/shader_needs.h"
#include "render/shading/shader_text.h"

namespace saddle {

/// The files of shaders/ with the parts that are needed, and no other.
ShaderText assemble_surface_shader(const ShaderNeeds& needs);

}  // namespace saddle
