// Poles and seams: which vertices of a grid are the same point of the surface.
#pragma once

#include <array>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/seam.h"

namespace saddle {

/// Whether two vertices are at the same place, but for rounding and what sin(2 pi) and its like
/// lose.
bool is_one_point(const Grid& grid, std::size_t a, std::size_t b);

/// Neighbouring vertices.
using Neighbours = std::array<std::uint32_t, 2>;

/// Of neighbours at the same place, those between which the surface stays there: sides that are
/// points, not curves that turn back in their middle.
std::vector<Neighbours> collapsed(const Surface& surface, const Grid& grid,
                                  std::span<const Neighbours> sides, unsigned threads);

/// Finds lines of the grid that are one point of the surface, opposite edges that meet, edges that
/// are folded, and neighbours at the same place. Gives their vertices one point in grid.mesh.point,
/// the number of its first vertex, and bitwise equal positions: at a seam those of the edge u0 or
/// v0. Opens the cells that this leaves without some of their corners.
Seams weld(const Surface& surface, unsigned threads, Grid& grid);

/// Says in a report how edges meet.
void report_seams(const Seams& seams, MeshReport& report);

}  // namespace saddle
