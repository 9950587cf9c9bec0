// The part of a shader that computes normals from a surface's formula.
#pragma once

#include <string>

#include "render/shading/shader_text.h"
#include "scene/model/shader_normal.h"

namespace saddle {

/// The function formula_normal() of shaders/normal.glsl, with those of shaders/functions.glsl that
/// the formula needs in front of it, and no other.
std::string normal_shader(const ShaderNormal& normal);

/// The program that finds out at which corners floats know the normal: shaders/trust.vert.glsl.
ShaderText trust_shader(const ShaderNormal& normal);

}  // namespace saddle
