// The shaders of a page: saddle's own, for the lights and materials of its scene.
#pragma once

#include <cstddef>
#include <vector>

#include "export/page_scene.h"
#include "render/shading/shader_lights.h"
#include "render/shading/shader_text.h"
#include "scene/model/scene.h"

namespace saddle {

/// The lights that shine, or may shine at another moment, in the order in which the shaders count
/// them.
std::vector<Light> page_lights(const Scene& scene);

struct PageShaders {
  std::vector<ShaderText> programs;     ///< GLSL ES 3.00 without its first line; the lines' first
  std::vector<std::size_t> of_surface;  ///< the program of each surface
  bool grey = true;                     ///< a light's colour is one number
};

PageShaders page_shaders(const PageScene& page);

}  // namespace saddle
