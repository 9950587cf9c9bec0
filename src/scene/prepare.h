// From the formulas of a scene to a surface that can be evaluated.
#pragma once

#include <string>
#include <vector>

#include "formula/scope.h"
#include "scene/scene.h"
#include "surface/surface.h"

namespace saddle {

/// All that has a name in the formulas: the scene's definitions and the surface's own x, y and z.
std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec);

struct PreparedSurface {
  Surface surface;
  double parse_ms = 0;    ///< text to graph
  double compile_ms = 0;  ///< derivatives and tapes
};

/// Parses and compiles surface `spec` of `scene` at the scene's time. Throws Error (Input):
/// anything wrong with a formula, a range that is empty, not finite or not constant, a surface
/// without a z.
PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec,
                                Order order = Order::First);

/// Throws what prepare_surface() would about the formulas and ranges of `spec`, in less time.
void check_formulas(const Scene& scene, const SurfaceSpec& spec);

/// What constant expressions of the scene may use: its definitions, which may use x, y and z of its
/// (last) surface.
std::vector<Definition> constant_names(const Scene& scene);

/// The value of a constant expression that may use the scene's parameters; `name` stands for it in
/// messages. Throws Error (Input): anything wrong with a formula, a value that is not finite.
double finite_constant(const Scene& scene, const std::string& name, const std::string& text);

}  // namespace saddle
