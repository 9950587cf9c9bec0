// The lights of a scene as its shaders want them: in eye coordinates, in units of the scene, those
// that are off left out.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.h"
#include "render/program.h"
#include "render/surface_shader.h"
#include "scene/camera.h"
#include "scene/scene.h"

namespace saddle {

/// The uniforms of one light, by their names in shaders/lighting.glsl.
struct ShaderLight {
  LightKind kind = LightKind::Directional;
  dvec3 position;
  dvec3 color;
  dvec3 highlight;
  dvec3 ambient;
  dvec3 attenuation;
  dvec3 spot_direction;
  dvec3 spot_edge;
};

/// The lights of a resolved scene that shine, sorted by kind. `unit`: what the shaders' lengths are
/// measured in.
std::vector<ShaderLight> shader_lights(const Scene& scene, const FittedCamera& camera, double unit);

/// What these lights need of the shader.
void add_light_needs(std::span<const ShaderLight> lights, ShaderNeeds& needs);

/// Lights that fit into a program at once, if it has room for so many uniform components.
std::size_t lights_at_once(int uniform_components);

/// Sets the uniforms of the lights that the program was made for.
void set_lights(Program& program, std::span<const ShaderLight> lights, const ShaderNeeds& needs);

/// The constant, linear and quadratic attenuation of a light that reaches as far as `range`.
dvec3 attenuation_of_range(double range);

}  // namespace saddle
