// Kinds of light: each has its function in shaders/lighting.glsl.
#pragma once

#include <span>

#include "base/vec.h"
#include "scene/model/scene.h"

namespace saddle {

struct ShaderLight;

/// A function of shaders/lighting.glsl that lights a surface, and the lights that it is for. One
/// row of a table in light_kinds.cpp.
struct LightKind {
  const char* name;      ///< defined where a scene has such a light
  const char* function;  ///< its argument is the light's index in the uniform arrays
  /// It reads light_attenuation where some light of the scene has an attenuation.
  bool reads_attenuation = false;
  bool is_cone = false;    ///< it reads spot_direction and spot_edge
  bool is_smooth = false;  ///< a cone with a smooth edge
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

/// It is dimmer at a distance.
bool is_attenuated(const ShaderLight& light);

}  // namespace saddle
