// A program that surfaces are drawn with, as people read it.
#pragma once

#include <string>
#include <vector>

#include "render/shading/shader_text.h"

namespace saddle {

struct SurfaceProgram {
  ShaderText text;
  std::vector<std::string> surfaces;  ///< names of those that it draws
  std::vector<std::string> left_out;  ///< parts, each with its reason
};

}  // namespace saddle
