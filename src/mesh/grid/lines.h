// Grid lines of a scene as chains of mesh edges.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/grid/grid.h"

namespace saddle {

/// Some of the grid's lines of constant u and of constant v. A line runs along the edges of cells
/// that have triangles, and is several chains where it is interrupted. Edges that are a single
/// point (the lines of constant latitude at a pole) are left out. Lines go through the vertices'
/// own corners, used or not.
std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid,
                                                   const std::vector<std::size_t>& columns,
                                                   const std::vector<std::size_t>& rows);

}  // namespace saddle
