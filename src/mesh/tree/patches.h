// Leaves as patches for the interval proof.
#pragma once

#include <span>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/proof/certify.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// The patch of each leaf. `allowed`: of each leaf, in units of length.
std::vector<Patch> patches_of(std::span<const Leaf> leaves, std::span<const double> allowed,
                              const Grid& grid, const CellTree& tree);

/// The lines of the root grid; they refer to `grid`.
inline RootLines root_lines(const Grid& grid) {
  return {grid.u, grid.v};
}

}  // namespace saddle
