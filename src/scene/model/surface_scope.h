// The formulas of a surface as nodes of a graph: which names they see, where the surface is, and
// the ends of ranges.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"
#include "formula/scope.h"
#include "scene/model/scene.h"
#include "surface/surface.h"

namespace saddle {

/// The formula of x, y or z (0 to 2); empty where it is a parameter. x and y default to the first
/// and the second parameter, where that is not the other coordinate.
std::string coordinate_formula(const SurfaceSpec& spec, std::size_t axis);

/// One of the surface's parameters has that name.
bool is_parameter(const SurfaceSpec& spec, const std::string& name);

/// z or xyz has a formula, or z is a parameter.
bool has_height(const SurfaceSpec& spec);

/// All that has a name in the formulas: the scene's definitions, the surface's own, and its x, y
/// and z; and how the surface sees them.
std::vector<Definition> surface_definitions(const Scene& scene, const SurfaceSpec& spec);
Scope::View surface_view(const Scene& scene, const SurfaceSpec& spec);

/// x, y and z where the surface is: undefined where its condition is false. Throws Error (Input): a
/// `where` that is no condition.
std::array<NodeId, 3> restricted_position(Graph& graph, Scope& scope, const SurfaceSpec& spec);

/// The unrestricted x, y and z.
std::array<NodeId, 3> position(const Scope& scope);

/// A formula that is true or false. Throws Error (Input) for another one.
NodeId parse_condition(const Graph& graph, Scope& scope, const std::string& text);

bool depends(const Graph& graph, NodeId node, Depends on);

/// The text of a range, so that carets point into all of it, and its ends.
struct RangeText {
  std::string name;
  std::string text;
  std::array<Span, 2> ends;

  RangeText(std::string parameter, const Range& range);
  Place place(Span part) const { return {name, text, part}; }
  Place place() const { return place({0, text.size()}); }
};

/// Both ends of a range as nodes. Throws Error (Input).
std::array<NodeId, 2> parse_ends(Scope& scope, const RangeText& range);

struct RangeEnds {
  double min = 0;
  double max = 0;
};

/// The values of parsed ends at the time t. Throws Error (Input) for ends that depend on more than
/// that, are not finite, or equal.
RangeEnds constant_ends(Scope& scope, const RangeText& range, const std::array<NodeId, 2>& ends,
                        double t);

/// The formulas of a surface in u and v alone, and where they are drawn. Where the ends of v depend
/// on u, the part of the way between them, 0 to 1, takes the place of v.
struct BoundSurface {
  Graph graph;
  std::array<NodeId, 3> r = {};       ///< x, y, z
  std::optional<NodeId> v = {};       ///< v itself, where it is not the variable
  std::optional<NodeId> color = {};   ///< the number that it is coloured by
  std::vector<NodeId> contours = {};  ///< the numbers that its level lines are of
  std::vector<NodeId> region = {};    ///< region_outputs() of a surface with a condition
  Domain domain;
  /// The ends of u, then of v, which are 0 and 1 where its ends depend on u; or of a curve's s.
  std::array<NodeId, 4> ends = {};
  bool flip = false;   ///< the front is where r_v x r_u points
  bool moves = false;  ///< it is another one at another time
};

}  // namespace saddle
