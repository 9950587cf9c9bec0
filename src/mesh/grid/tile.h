// The one pass over a grid that every vertex and cell goes through: a row of a tile is computed,
// written where the mesh wants it and made into triangles with the row below, all while it is in
// the fastest cache. What is not plain is left open for those who look closer.
#pragma once

#include <vector>

#include "eval/batch.h"
#include "mesh/grid/cell_loops.h"
#include "mesh/grid/grid.h"

namespace saddle {

/// What all vertices of one row of a tile have in common.
struct RowSummary {
  bool finite = false;     ///< positions, normals and areas are
  double least_cross = 0;  ///< smallest |r_u x r_v|
  double largest_uu = 0;   ///< largest |r_u|^2 and |r_v|^2
  double largest_vv = 0;
};

struct TileSummary {
  std::vector<RowSummary> rows;    ///< from the tile's lowest row
  Bounds bounds;                   ///< of the finite rows
  std::vector<CellSagitta> worst;  ///< the worst plain cell of each few
};

/// Takes the rows of a tile (tape: Surface::normals) into grid.mesh and grid.cells, whose arrays
/// have their sizes. Each tile writes its own part.
TileSummary take_tile(TileRows& rows, Grid& grid);

}  // namespace saddle
