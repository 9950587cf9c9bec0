// The lights of a scene as uniforms of its shaders: in eye coordinates, in units of the scene,
// without lights that are off.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/vec.h"
#include "render/gl/program.h"
#include "render/shading/light_kinds.h"
#include "render/shading/shader_needs.h"
#include "scene/model/camera.h"
#include "scene/model/scene.h"

namespace saddle {

/// The light of a resolved scene is on, and not black.
bool shines(const Light& light);

/// The lights of a resolved scene that shine, sorted by kind; none if no surface is lit. `unit`:
/// what the shaders' lengths are measured in.
std::vector<ShaderLight> shader_lights(const Scene& scene, const FittedCamera& camera, double unit);

/// Some light is a spot light.
bool has_cone(const ShaderNeeds& needs);

/// Adds the parts of the shader that these lights need.
void add_light_needs(std::span<const ShaderLight> lights, ShaderNeeds& needs);

/// Lights that fit into a program at once, if it has room for so many uniform components.
std::size_t lights_at_once(int uniform_components);

/// Sets the uniforms of the lights that the program was made for.
void set_lights(Program& program, std::span<const ShaderLight> lights, const ShaderNeeds& needs);

/// The constant, linear and quadratic attenuation of a light that reaches as far as `range`.
dvec3 attenuation_of_range(double range);

}  // namespace saddle
