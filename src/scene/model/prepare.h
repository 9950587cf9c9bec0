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

/// The formula of x, y or z (0 to 2); empty where it is a parameter. x and y default to the first
/// and the second parameter, where that is not the other coordinate.
std::string coordinate_formula(const SurfaceSpec& spec, std::size_t axis);

/// One of the surface's parameters has that name.
bool is_parameter(const SurfaceSpec& spec, const std::string& name);

/// z has a formula, or is a parameter.
bool has_height(const SurfaceSpec& spec);

/// All that has a name in the formulas: the scene's definitions, the surface's own, and its x, y
/// and z; and how the surface sees them.
std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec);
Scope::View surface_view(const Scene& scene, const SurfaceSpec& spec);

/// v between ends that depend on u, from the lower one (s = 0) to the upper one (s = 1), both
/// exact. The part s takes the place of v as a variable of the surface.
NodeId between(Graph& graph, const std::array<NodeId, 2>& ends);

/// x, y and z where the surface is: undefined where its condition is false. Throws Error (Input): a
/// `where` that is no condition.
std::array<NodeId, 3> restricted_position(Graph& graph, Scope& scope, const SurfaceSpec& spec);

/// The formulas of a surface in u and v alone, and where they are drawn. Where the ends of v depend
/// on u, the part of the way between them, 0 to 1, takes the place of v.
struct BoundSurface {
  Graph graph;
  std::array<NodeId, 3> r = {};      ///< x, y, z
  std::optional<NodeId> v = {};      ///< v itself, where it is not the variable
  std::optional<NodeId> color = {};  ///< the number that it is coloured by
  std::vector<NodeId> region = {};   ///< region_outputs() of a surface with a condition
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

/// bind_surface() and make_surface().
PreparedSurface prepare_surface(const Scene& scene, const SurfaceSpec& spec,
                                Order order = Order::First);

/// The names that constant expressions of a surface may use, or, without one, those of the scene:
/// its definitions, which may use x, y and z of its (last) surface.
std::vector<Definition> constant_names(const Scene& scene, const SurfaceSpec* spec = nullptr);
Scope::View constant_view(const Scene& scene, const SurfaceSpec* spec = nullptr);

/// The value of a constant expression that may use the scene's parameters; `name` stands for it in
/// messages. Throws Error (Input): anything wrong with a formula, a value that is not finite.
double finite_constant(const Scene& scene, const std::string& name, const std::string& text);

}  // namespace saddle
