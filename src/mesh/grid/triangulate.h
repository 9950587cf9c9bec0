// Cells of a grid into triangles, one by one: those that the pass over the grid left open.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid/corners.h"
#include "mesh/grid/grid.h"
#include "mesh/model/tolerances.h"

namespace saddle {

/// Cuts each cell along one of its diagonals: the one whose triangles face as their corners'
/// normals do, then the one with the smaller sagitta, then the shorter one. Triangles without area,
/// as at poles, are left out. Writes grid.mesh.triangles and grid.cells of these cells.
void triangulate(Grid& grid, std::span<const OpenCell> cells);

/// Appends the triangles of one cell, in the order of slots; at most two.
void cut_cell(const Grid& grid, const std::array<std::uint32_t, 4>& corners,
              Array<Triangle>& triangles);

/// Triangles of a polygon whose corners are these points of the surface: two fewer than it has
/// corners at which it goes on to another point. Takes the others out of `points`.
std::size_t triangles_between(std::vector<std::uint32_t>& points);

/// Whether a triangle of corners has no area: two are one point, or it is flat within rounding.
bool is_collapsed(const Grid& grid, const Triangle& triangle);

/// The height of a surface's arc above the chord from a to b, from the normals at its ends, for a
/// parabolic arc: |(n_b - n_a) . (p_b - p_a)| / 8.
inline double sagitta(const dvec3& p_a, const dvec3& n_a, const dvec3& p_b, const dvec3& n_b) {
  return 0.125 * glm::abs(glm::dot(n_b - n_a, p_b - p_a));
}

/// Whether `a` is less than `b` by more than rounding may make of equal ones.
inline bool is_smaller(double a, double b) {
  return a < b * (1 - kTie);
}

}  // namespace saddle
