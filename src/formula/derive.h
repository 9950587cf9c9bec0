// The exact partial derivative of a formula, as another formula.
#pragma once

#include <span>
#include <vector>

#include "formula/graph.h"

namespace saddle {

/// d root / d symbol for each root, by the chain rule with the rules of formula/ops.def.
/// At a kink (abs at 0, min and max where both are equal) it is the derivative from one side: the
/// right one for abs, the first argument's for min and max. At a jump (floor, sign, comparisons)
/// it is that of both sides, 0. Shared parts of the roots are differentiated once.
std::vector<NodeId> derive(Graph& graph, std::span<const NodeId> roots, Symbol symbol);

}  // namespace saddle
