// Surfaces for tests, from formulas as a user writes them.
#pragma once

#include <array>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "formula/graph.h"
#include "formula/scope.h"
#include "surface/surface.h"

namespace saddle {

inline constexpr double kPi = std::numbers::pi;

/// `definitions`: what x, y and z use, such as {{"r", "0.5"}}. For a flipped surface set `flip` of
/// the result.
inline Surface surface_from_text(const std::string& x, const std::string& y, const std::string& z,
                                 const Domain& domain, std::vector<Definition> definitions = {},
                                 Order order = Order::First) {
  Graph graph;
  Scope scope(graph, std::move(definitions));
  const std::array<NodeId, 3> parsed = {scope.parse("x", x), scope.parse("y", y),
                                        scope.parse("z", z)};
  const std::vector<NodeId> bound = scope.bind(parsed, 0);
  return make_surface(graph, {bound[0], bound[1], bound[2]}, domain, false, order);
}

/// z over the (x, y) plane, with second derivatives.
inline Surface height_field(const std::string& z, const Domain& domain = {-1, 1, -1, 1}) {
  return surface_from_text("u", "v", z, domain, {}, Order::Second);
}

}  // namespace saddle
