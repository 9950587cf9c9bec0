// Features of sides that have strips: jumps close to each other, with the thin sheets between them,
// and cliffs, with their segments.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/features/cliffs.h"
#include "mesh/features/discontinuities.h"
#include "mesh/mesher/trace_options.h"
#include "mesh/tree/edge_table.h"

namespace saddle {

class CellTree;

/// Records the sides whose jumps are close to each other. `found`: on the lines of the sides.
/// Returns which they are.
std::vector<bool> add_strips(std::span<const Side> sides,
                             std::span<const LocatedDiscontinuity> found, double delta,
                             const TraceOptions& options, CellTree& tree);

/// Records a cliff on each side. Each segment has two vertices of its own; foot and head have one
/// more each, with the normal of the sheet. An end of a side is the sheet's if the cliff begins
/// there.
void add_cliffs(std::span<const Side> sides, std::span<const Cliff> cliffs, unsigned threads,
                CellTree& tree);

/// The vertex whose place a feature takes: an end of its side within rounding, else the first
/// vertex beside it.
std::uint32_t place_to_keep(const Side& side, const std::array<std::uint32_t, 2>& beside,
                            const CellTree& tree);

}  // namespace saddle
