// Features of sides that have strips: several jumps, with the sheets between them, and cliffs, with
// their segments.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "mesh/features/cliffs.h"
#include "mesh/features/discontinuities.h"
#include "mesh/mesher/trace_options.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/edge_table.h"

namespace saddle {

class CellTree;

/// Records the sides with several jumps, if all of them are known. Where many sides have too many
/// jumps for that, sides whose jumps are far apart are left to be halved. `found`: on the lines of
/// the sides. Returns which were recorded.
std::vector<bool> add_strips(std::span<const Side> sides,
                             std::span<const LocatedDiscontinuity> found, double delta,
                             const TraceOptions& options, CellTree& tree);

/// Records a cliff on each side. Each segment has two vertices of its own; foot and head have one
/// more each, with the normal of the sheet. An end of a side is the sheet's if the cliff begins
/// there.
void add_cliffs(std::span<const Side> sides, std::span<const Cliff> cliffs, unsigned threads,
                CellTree& tree);

/// Sets the normals of vertices to those of the surface at other places.
void set_normals(std::span<const std::uint32_t> vertices, std::span<const dvec2> at,
                 unsigned threads, CellTree& tree);

/// Where a vertex beside a jump gets its normal: a little farther on its way to another vertex of
/// its sheet. At the jump itself rounding may choose the slopes of the other sheet, as of abs(u-v)
/// where u > v+0 jumps.
inline dvec2 beside_jump(const dvec2& at_jump, const dvec2& on_sheet) {
  return glm::mix(at_jump, on_sheet, kNearly);
}

/// The vertex whose place a feature takes: an end of its side within rounding, else the first
/// vertex beside it.
std::uint32_t place_to_keep(const Side& side, const std::array<std::uint32_t, 2>& beside,
                            const CellTree& tree);

}  // namespace saddle
