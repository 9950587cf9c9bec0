// The last step before a graph is evaluated or printed: powers that are cheaper as products or
// roots.
#pragma once

#include <vector>

#include "formula/graph.h"

namespace saddle {

/// The part of the graph that the roots need, where x^n with a whole n of up to 16 is a product of
/// squares, x^-n its reciprocal and x^0.5 a square root. The roots become nodes of the result.
Graph lower_powers(const Graph& graph, std::vector<NodeId>& roots);

}  // namespace saddle
