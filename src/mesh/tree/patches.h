// Leaves as patches for the interval proof.
#pragma once

#include "mesh/grid/grid.h"
#include "mesh/proof/certify.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// The patch of a leaf. `allowed`: in units of length.
Patch patch_of(const Leaf& leaf, double allowed, const Grid& grid, const CellTree& tree);
/// The number of the root cell that holds a leaf.
std::size_t root_cell_of(const Leaf& leaf, const Grid& grid);

/// The lines of the root grid; they refer to `grid`.
inline RootLines root_lines(const Grid& grid) {
  return {grid.u, grid.v};
}

}  // namespace saddle
