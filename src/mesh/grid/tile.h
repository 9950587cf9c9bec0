// The pass over all vertices and cells of a grid. Each row of a tile is evaluated, written to the
// mesh and triangulated with the row below while it is in the fastest cache. Cells that are not
// plain stay open.
#pragma once

#include <vector>

#include "eval/batch.h"
#include "mesh/grid/cell_loops.h"
#include "mesh/grid/grid.h"

namespace saddle {

/// Bounds for all vertices of one row of a tile.
struct RowSummary {
  bool finite = false;     ///< positions, normals and areas are
  double least_cross = 0;  ///< smallest |r_u x r_v|
  double largest_uu = 0;   ///< largest |r_u|^2 and |r_v|^2
  double largest_vv = 0;
};

struct TileSummary {
  std::vector<RowSummary> rows;    ///< from the tile's lowest row
  Bounds bounds;                   ///< of the finite rows
  std::vector<CellSagitta> worst;  ///< the largest sagitta of each 16 plain cells
};

/// Writes the rows of a tile (tape: Surface::normals) to grid.mesh and grid.cells, which are
/// allocated. Each tile writes its own part.
TileSummary take_tile(TileRows& rows, Grid& grid);

}  // namespace saddle
