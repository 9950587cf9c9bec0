// The files of shaders/, embedded at build time.
#pragma once

#include <string_view>

namespace saddle {

/// The text of shaders/`name` ("surface.frag.glsl"), empty if there is no such file.
std::string_view shader_source(std::string_view name);

}  // namespace saddle
