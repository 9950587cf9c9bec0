// Which parts of the surface's shader a scene needs, and its text with just those.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.h"

namespace saddle {

/// Everything the shader is put together from; what is not here does not change its text.
struct ShaderNeeds {
  std::vector<bool> directional;  ///< one per light: directional, or a point
  bool specular = false;          ///< some material reflects
  bool two_materials = false;     ///< some surface's sides differ
  bool orthographic = false;
};

ShaderNeeds shader_needs(const Scene& scene);

/// The light adds something: its colour is not black.
bool shines(const Light& light);

/// `source` with the constants of `needs` after its first line, which is `#version`.
std::string assemble_shader(std::string_view source, const ShaderNeeds& needs);

}  // namespace saddle
