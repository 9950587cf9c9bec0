// The materials of a surface as its shaders want them.
#pragma once

#include "render/gl/program.h"
#include "render/shading/shader_needs.h"
#include "scene/model/scene.h"

namespace saddle {

/// What the surface's materials need of the shader, where `needs` says which sides are seen and
/// whether it is coloured. `emission`: whether it may shine, which it does once, whatever the
/// lights.
void add_material_needs(const SurfaceSpec& surface, bool emission, ShaderNeeds& needs);

/// Sets the uniforms of the materials that the program was made for.
void set_materials(Program& program, const SurfaceSpec& surface, const ShaderNeeds& needs);

}  // namespace saddle
