// From the formulas of a scene to a surface that can be evaluated.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formula/scope.h"
#include "scene/model/scene.h"
#include "scene/model/surface_scope.h"
#include "surface/surface.h"

namespace saddle {

/// v between ends that depend on u, from the lower one (s = 0) to the upper one (s = 1), both
/// exact. The part s takes the place of v as a variable of the surface.
NodeId between(Graph& graph, const std::array<NodeId, 2>& ends);

/// Parses surface `spec` of `scene` at the scene's time; also one that stands for a curve, which is
/// its r(u), or a point, with the ball round it. Throws Error (Input): anything wrong with
/// a formula, a range that is empty, not finite or circular, a surface without a z.
BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec);

struct PreparedSurface {
  Surface surface;
  std::vector<Tape> contours;  ///< the numbers that its level lines are of, each an output
  bool moves = false;          ///< it is another one at another time
  double parse_ms = 0;         ///< text to graph
  double compile_ms = 0;       ///< derivatives and tapes
};

/// bind_surface() and make_surface(), with x, y and z multiplied by the factors of `stretch`.
PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec,
                                Order order = Order::First, const dvec3& stretch = dvec3(1));

/// The names that constant expressions of a surface may use, or, without one, those of the scene:
/// its definitions, which may use x, y and z of its (last) surface.
std::vector<Definition> constant_names(const Scene& scene, const SurfaceSpec* spec = nullptr);
Scope::View constant_view(const Scene& scene, const SurfaceSpec* spec = nullptr);

/// The value of a constant expression that may use the scene's parameters; `name` stands for it in
/// messages. Throws Error (Input): anything wrong with a formula, a value that is not finite.
double finite_constant(const Scene& scene, const std::string& name, const std::string& text);

}  // namespace saddle
