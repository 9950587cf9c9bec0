// Grid lines of a scene as chains of mesh edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid.h"

namespace saddle {

/// options.lines_u lines of constant u and options.lines_v of constant v. A line runs along the
/// edges of cells that have triangles, and is several chains where it is interrupted. Edges that
/// are a single point (the lines of constant latitude at a pole) are left out.
/// `corner`: by vertex of the grid, the corner that stands for it; empty: its own.
std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid,
                                                   std::span<const std::uint32_t> corner,
                                                   const GridOptions& options);

}  // namespace saddle
