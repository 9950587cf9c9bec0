// Differences of one function at two places near each other, as (f(u+h) - f(u))/h: interval bounds
// of f(u+h) and of f(u) say nothing of what the two have in common, so those of their difference
// are as wide as both together. By the mean value theorem it is h f'(w), with a w between u and
// u+h.
// Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, "Introduction to interval analysis", 2009,
// chapter 6.
#pragma once

#include <span>
#include <vector>

#include "formula/graph.h"

namespace saddle {

/// The roots, with an Op::Narrow around each difference of this kind: the same values, with
/// narrower enclosures. Differences inside of f and of its derivatives are narrowed, too. A formula
/// without such differences keeps its nodes.
std::vector<NodeId> narrow_differences(Graph& graph, std::span<const NodeId> roots);

}  // namespace saddle
