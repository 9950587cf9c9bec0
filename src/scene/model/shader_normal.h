// A surface's normal as GLSL, from the derivatives of its formulas.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// Numbers that a program may get for the formula.
inline constexpr std::size_t kMostConstants = 64;

struct ShaderNormal {
  /// Statements that compute the variables r_u and r_v from the floats u and v, the user's, with
  /// numbers from an array `constant`.
  std::string code;
  std::vector<double> constants;
  bool flip = false;  ///< the front is where r_v x r_u points
  /// Why there is no code: an operation without a float version, or far too many of them.
  std::optional<std::string> obstacle;
};

/// The formula of surface `spec` of a resolved scene, at its moment. The code is the same whatever
/// values t and the parameters have, but for exponents that are whole. Throws Error (Input) as
/// bind_surface().
ShaderNormal shader_normal(const Scene& scene, const SurfaceSpec& spec);

}  // namespace saddle
