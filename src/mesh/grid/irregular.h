// Which vertices of a grid are not defined or have no regular normal, and which cells that opens.
#pragma once

#include <span>

#include "mesh/grid/tile.h"
#include "surface/surface.h"

namespace saddle {

/// Looks again at the rows of tiles whose summaries do not show that all of their vertices are
/// regular (see unit_normal; the scales are those of a vertex and its neighbours). Fills
/// grid.singular and grid.left_out_count, marks cells Open or LeftOut, and mends the normals of
/// regular vertices whose lengths overflow.
void find_irregular(const Surface& surface, const GridTiling& tiling,
                    std::span<const TileSummary> tiles, unsigned threads, Grid& grid);

}  // namespace saddle
