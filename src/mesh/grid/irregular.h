// Finds vertices of a grid that are undefined or have no regular normal, and opens their cells.
#pragma once

#include <span>

#include "mesh/grid/tile.h"
#include "surface/surface.h"

namespace saddle {

/// Evaluates again the rows of tiles whose summaries do not prove that all of their vertices are
/// regular (see unit_normal; the scales are those of a vertex and its neighbours). Sets
/// grid.singular and grid.left_out_count, marks cells Open or LeftOut, and sets the normals of
/// regular vertices whose tangents overflow in the pass over the grid.
void find_irregular(const Surface& surface, const GridTiling& tiling,
                    std::span<const TileSummary> tiles, unsigned threads, Grid& grid);

}  // namespace saddle
