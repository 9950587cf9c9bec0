// From the formulas of a scene to a surface that can be evaluated.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "formula/scope.h"
#include "scene/model/scene.h"
#include "surface/surface.h"

namespace saddle {

/// All that has a name in the formulas: the scene's definitions and the surface's own x, y and z.
std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec);

/// v between ends that depend on u, from the lower one (s = 0) to the upper one (s = 1), both
/// exact. The part s takes the place of v as a variable of the surface.
NodeId between(Graph& graph, const std::array<NodeId, 2>& ends);

/// The formulas of a surface in u and v alone, and where they are drawn. Where the ends of v depend
/// on u, the part of the way between them, 0 to 1, takes the place of v.
struct BoundSurface {
  Graph graph;
  std::array<NodeId, 3> r = {};      ///< x, y, z
  std::optional<NodeId> v = {};      ///< v itself, where it is not the variable
  std::optional<NodeId> color = {};  ///< the number that it is coloured by
  Domain domain;
  bool flip = false;   ///< the front is where r_v x r_u points
  bool moves = false;  ///< it is another one at another time
};

/// Parses surface `spec` of `scene` at the scene's time. Throws Error (Input): anything wrong with
/// a formula, a range that is empty, not finite or circular, a surface without a z.
BoundSurface bind_surface(const Scene& scene, const SurfaceSpec& spec);

struct PreparedSurface {
  Surface surface;
  bool moves = false;     ///< it is another one at another time
  double parse_ms = 0;    ///< text to graph
  double compile_ms = 0;  ///< derivatives and tapes
};

/// bind_surface() and make_surface(), with x, y and z multiplied by the factors of `stretch`.
PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec,
                                Order order = Order::First, const dvec3& stretch = dvec3(1));

/// The names that constant expressions of the scene may use: its definitions, which may use x, y
/// and z of its (last) surface.
std::vector<Definition> constant_names(const Scene& scene);

/// The value of a constant expression that may use the scene's parameters; `name` stands for it in
/// messages. Throws Error (Input): anything wrong with a formula, a value that is not finite.
double finite_constant(const Scene& scene, const std::string& name, const std::string& text);

}  // namespace saddle
