// The last step before a graph is evaluated or printed: powers that are cheaper as products or
// roots.
#pragma once

#include <cstdint>
#include <vector>

#include "formula/graph.h"

namespace saddle {

/// How whole-number powers are lowered: products are faster in doubles; kept whole, they have
/// narrower enclosures (u^3 over [-1, 2] is [-1, 8], while u * u^2 is [-4, 8]).
enum class Powers : std::uint8_t { Products, Whole };

/// The part of the graph that the roots need, where x^0.5 is a square root and, for
/// Powers::Products, x^n with a whole n of up to 16 a product of squares, x^-n its reciprocal. The
/// roots become nodes of the result.
Graph lower(const Graph& graph, std::vector<NodeId>& roots, Powers powers = Powers::Products);

}  // namespace saddle
