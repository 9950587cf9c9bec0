// Follows edge features from leaf to leaf and across seams, so that a leaf that a feature enters
// has the place where it leaves.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/mesher/trace_options.h"
#include "mesh/model/seam.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct Grid;

/// Searches all sides of leaves that have an edge feature on one side, until no leaf has a new one.
/// Returns the numbers of the leaves whose first feature was found on the way.
std::vector<std::size_t> follow_features(const TraceOptions& options, std::span<Leaf> leaves,
                                         CellTree& tree);

/// Searches the sides on a seam whose partners across the seam carry a feature.
void trace_features_across_seams(const Seams& seams, const TraceOptions& options, const Grid& grid,
                                 CellTree& tree);

}  // namespace saddle
