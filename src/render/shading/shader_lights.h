// The lights of a scene as its shaders want them: in eye coordinates, in units of the scene, those
// that are off left out.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.h"
#include "render/gl/program.h"
#include "render/shading/surface_shader.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

struct ShaderLight;

/// A function of shaders/lighting.glsl that lights a surface, and the lights that it is for. One
/// row of a table in shader_lights.cpp.
struct LightKind {
  const char* name;      ///< defined where a scene has such a light
  const char* function;  ///< its argument is the light's index in the uniform arrays
  /// It reads light_attenuation where some light of the scene has an attenuation.
  bool reads_attenuation = false;
  bool is_cone = false;  ///< it reads spot_direction and spot_edge
  /// Whether a light is of this kind; each light is of one kind alone. `perspective`: the direction
  /// to the eye is that to its place.
  bool (*has)(const Light& light, const ShaderLight& uniforms, bool perspective);
};

/// All kinds, in the order in which shaders call their functions.
std::span<const LightKind> light_kinds();

/// The uniforms of one light. Their names in shaders/lighting.glsl are in shader_lights.cpp.
struct ShaderLight {
  const LightKind* kind = nullptr;  ///< one of light_kinds()
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

/// Some light is a spot light.
bool has_cone(const ShaderNeeds& needs);

/// What these lights need of the shader.
void add_light_needs(std::span<const ShaderLight> lights, ShaderNeeds& needs);

/// Lights that fit into a program at once, if it has room for so many uniform components.
std::size_t lights_at_once(int uniform_components);

/// Sets the uniforms of the lights that the program was made for.
void set_lights(Program& program, std::span<const ShaderLight> lights, const ShaderNeeds& needs);

/// The constant, linear and quadratic attenuation of a light that reaches as far as `range`.
dvec3 attenuation_of_range(double range);

}  // namespace saddle
