// From a sampled grid to its mesh: welding, cutting the open cells, closing gaps.
#pragma once

#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/grid/weld.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// Welds a grid with kept cells and cuts those that the pass over it left open. Adds how edges
/// meet, singular points and triangles without area to `report`. Returns the cells
/// that were open. Throws Error (Nothing) if the surface is a point or a curve, or no cell has any
/// area.
std::vector<std::size_t> cut_grid(const Surface& surface, unsigned threads, Grid& grid,
                                  MeshReport& report);

/// The mesh of a grid that is cut, without gaps, with some of the grid's columns and rows as lines.
/// `plain`: no cell was open or left out.
Mesh finish_grid(Grid&& grid, bool plain, const std::vector<std::size_t>& columns,
                 const std::vector<std::size_t>& rows);

}  // namespace saddle
