// Poles and seams: which vertices of a grid are the same point of the surface.
#pragma once

#include "mesh/grid.h"
#include "mesh/seam.h"

namespace saddle {

/// How the edges u0 and u1 meet, and v0 and v1.
struct Seams {
  Seam u;
  Seam v;
};

/// Whether two vertices are at the same place, but for rounding and what sin(2 pi) and its like
/// lose.
bool is_one_point(const Grid& grid, std::size_t a, std::size_t b);

/// Finds lines of the grid that are one point of the surface, opposite edges that meet, and
/// neighbours at the same place. Gives their vertices one point in grid.mesh.point, the number of
/// its first vertex, and bitwise equal positions: at a seam those of the edge u0 or v0. Opens the
/// cells that this leaves without some of their corners.
Seams weld(Grid& grid);

}  // namespace saddle
