// The materials of a surface as uniforms of its shaders.
#pragma once

#include "render/gl/program.h"
#include "render/shading/shader_needs.h"
#include "scene/model/scene.h"

namespace saddle {

/// The two materials of a surface, or of a part of one.
struct SideMaterials {
  Material front;
  Material back;
};

/// Adds the parts of the shader that the materials need; `needs` says which sides are
/// seen and whether it is coloured. `emission`: it may shine, which it does in one pass of several.
void add_material_needs(const SideMaterials& materials, bool emission, ShaderNeeds& needs);

/// Sets the uniforms of the materials that the program was made for.
void set_materials(Program& program, const SideMaterials& materials, const ShaderNeeds& needs);

}  // namespace saddle
