// Which parts of the surface's shaders a scene needs, and their text with just those.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"
#include "scene/model/shader_normal.h"

namespace saddle {

struct LightKind;

/// Everything the shaders are put together from; what is not here does not change their text.
struct ShaderNeeds {
  std::vector<const LightKind*> lights;  ///< in the order of light_kinds()
  bool grey = true;                      ///< no light has a hue
  bool attenuation = false;              ///< some light, a spot light perhaps, is weaker from afar
  bool focus = false;                    ///< some cone has an exponent
  bool ambient = false;                  ///< some light has an ambient part
  bool highlights = false;               ///< some light mirrors in a colour of its own
  bool specular = false;                 ///< the material mirrors
  bool blinn = false;
  bool emission = false;       ///< the material shines by itself
  bool two_sided = true;       ///< back faces can be seen
  bool two_materials = false;  ///< and look different
  bool per_vertex = false;
  bool orthographic = false;
  bool colored = false;        ///< each point has a colour of its own, in place of the materials'
  bool normal_matrix = false;  ///< the model is not only turned, moved and scaled evenly
  const ShaderNormal* normal = nullptr;  ///< the formula for normals; none: they are interpolated
  bool see_through = false;              ///< it is a layer of what is seen, with others behind

  bool operator==(const ShaderNeeds&) const = default;
};

/// Sources of a program.
struct ShaderText {
  std::string vertex;
  std::string fragment;
};

/// The files of shaders/ with the parts that are needed, and no other.
ShaderText assemble_surface_shader(const ShaderNeeds& needs);

/// The text without the lines that #ifdef, #ifndef, #else and #endif leave out for these names.
std::string keep_defined(const std::string& text, const std::vector<std::string>& names);

}  // namespace saddle
