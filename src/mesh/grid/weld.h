// Welding: finds vertices of a grid that are the same point of the surface, at poles and seams.
#pragma once

#include <array>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/seam.h"

namespace saddle {

/// Whether two vertices are at the same place, within rounding and within the error of sin(2 pi).
bool is_one_point(const Grid& grid, std::size_t a, std::size_t b);

/// The same, or within rounding of the parameters.
bool is_one_point(const Surface& surface, const Grid& grid, std::size_t a, std::size_t b);

/// Whether the way between two vertices is short beside the same step elsewhere, of a length in
/// local units, or within rounding: narrow parts of a surface are no points.
bool is_short_beside(const Grid& grid, std::size_t a, std::size_t b, double length);

/// Neighbouring vertices.
using Neighbours = std::array<std::uint32_t, 2>;

/// The neighbours at the same place between which the surface stays there: sides that are points,
/// not curves that return.
std::vector<Neighbours> collapsed(const Surface& surface, const Grid& grid,
                                  std::span<const Neighbours> sides, unsigned threads);

/// Finds lines of the grid that are one point of the surface, opposite edges that meet, edges that
/// are folded, and neighbours at the same place. Gives their vertices one point in grid.mesh.point,
/// the number of its first vertex, and bitwise equal positions: at a seam those of the edge u0 or
/// v0. Opens the cells that this leaves without some of their corners.
Seams weld(const Surface& surface, unsigned threads, Grid& grid);

/// Writes to a report how edges meet.
void report_seams(const Seams& seams, MeshReport& report);

}  // namespace saddle
