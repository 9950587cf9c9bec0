// Cuts single cells into triangles: the open ones of a grid, and leaves of two triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid/cell_diagonal.h"
#include "mesh/grid/corners.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/vertex_columns.h"

namespace saddle {

/// Cuts each cell along one of its diagonals: first the one with more triangles, then with more
/// that face as their corners' normals do, then with the smaller sagitta, then the shorter one.
/// Triangles without area, as at poles, are left out. Writes grid.mesh.triangles and grid.cells of
/// the cells.
void triangulate(Grid& grid, std::span<const OpenCell> cells);

/// Appends the triangles of one cell, in the order of slots; at most two.
void cut_cell(const Grid& grid, const std::array<std::uint32_t, 4>& corners,
              Array<Triangle>& triangles);

/// The number of triangles of a polygon whose corners are these points of the surface: two fewer
/// than it has points, without repetitions of neighbours. Erases these from `points`.
std::size_t triangles_between(std::vector<std::uint32_t>& points);

/// Whether a triangle has no area: two corners are one point, or it is flat within rounding.
bool is_collapsed(const Grid& grid, const Triangle& triangle);

inline double sagitta(const dvec3& p_a, const dvec3& n_a, const dvec3& p_b, const dvec3& n_b) {
  return sagitta(loop_vector(p_a), loop_vector(n_a), loop_vector(p_b), loop_vector(n_b));
}

}  // namespace saddle
