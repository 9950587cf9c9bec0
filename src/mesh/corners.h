// The corners of cells that the pass over the grid left open: a regular vertex is one corner; a
// singular one has a corner for each different one-sided limit among the cells around it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/grid.h"

namespace saddle {

/// Normals of cells around a singular vertex that differ by no more share a corner, degrees. Less
/// is no visible crease, and one corner in place of four keeps smooth poles smooth.
inline constexpr double kCreaseDegrees = 1;

/// A cell that is to be cut, with the corners of its four slots.
struct OpenCell {
  std::size_t cell;
  std::array<std::uint32_t, 4> corners;
};

/// Lists the open cells. A singular vertex takes the limits of its cells, or the normal of a cell's
/// face where the cell has no limit: the first is the vertex's own, others are new corners at the
/// end of grid.mesh (zero if the cell has no area either). Adds the singular points and the
/// evaluations to `report`.
std::vector<OpenCell> open_cells(const Surface& surface, unsigned threads, Grid& grid,
                                 MeshReport& report);

}  // namespace saddle
