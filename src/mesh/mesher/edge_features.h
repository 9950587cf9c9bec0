// Finds the edge features of sides, which cut them: boundaries, jumps, poles and creases. From
// sides without a known feature to records in the cell tree's edge table.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesher/trace_options.h"
#include "mesh/tree/edge_table.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Searches sides and records their features in the cell tree. Once the budget is spent, the
/// remaining sides stay unsearched.
void trace_features(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// Finds boundaries, jumps and poles. A side without any is recorded as continuous, not as
/// searched: it may have a crease.
void find_jumps(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// Appends the unsearched sides of a leaf.
void append_unsearched(const Leaf& leaf, const CellTree& tree, std::vector<Side>& sides);
/// The unsearched sides of leaves, sorted and without duplicates.
std::vector<Side> unsearched_sides(std::span<const Leaf> leaves, unsigned threads,
                                   const CellTree& tree);
/// Sorts sides and removes duplicates.
void sort_sides(std::vector<Side>& sides);

}  // namespace saddle
