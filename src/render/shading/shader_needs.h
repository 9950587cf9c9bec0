// The parts of the surface's shaders that a scene needs.
#pragma once

#include <vector>

#include "render/shading/light_kinds.h"
#include "scene/model/shader_normal.h"

namespace saddle {

/// Where the diffuse colour comes from in place of the material.
enum class TextureUse { None, Picture, Checker };

/// Decides the shaders' text; nothing else changes it.
struct ShaderNeeds {
  std::vector<const LightKind*> lights = {};  ///< in the order of light_kinds()
  bool grey = true;                           ///< no light has a hue
  bool attenuation = false;  ///< some light, a spot light perhaps, is weaker from afar
  bool focus = false;        ///< some cone has an exponent
  bool ambient = false;      ///< some light has an ambient part
  bool highlights = false;   ///< some light mirrors in a colour of its own
  bool specular = false;     ///< the material mirrors
  bool blinn = false;
  bool emission = false;       ///< the material shines by itself
  bool two_sided = true;       ///< back faces can be seen
  bool two_materials = false;  ///< and look different
  bool per_vertex = false;
  bool unlit = false;  ///< the colour as it is: no light, no emission
  bool orthographic = false;
  bool colored = false;        ///< each point has a colour of its own, in place of the materials'
  bool normal_matrix = false;  ///< the model is not only turned, moved and scaled evenly
  const ShaderNormal* normal = nullptr;  ///< the formula for normals; none: they are interpolated
  TextureUse textured = TextureUse::None;
  bool see_through = false;  ///< it is drawn in layers, with others behind

  bool operator==(const ShaderNeeds&) const = default;
};

}  // namespace saddle
