// Corners of a grid mesh with their normals: one per regular vertex; at a singular vertex one for
// each different one-sided limit among the cells around it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid.h"

namespace saddle {

/// Normals of cells around a singular vertex that differ by no more share a corner, degrees. Less
/// is no visible crease, and one corner in place of four keeps smooth poles smooth.
inline constexpr double kCreaseDegrees = 1;

struct Corners {
  /// Per cell, the corners of its four slots; meaningless for cells that are left out.
  std::vector<std::array<std::uint32_t, 4>> of_cell;
  std::vector<dvec3> normal;          ///< unit; zero if the corner's cell has no area either
  std::vector<std::uint32_t> vertex;  ///< the vertex that each corner belongs to
};

/// The exact normal at each used vertex that is regular, zero at the others.
std::vector<dvec3> regular_normals(const Surface& surface, const Grid& grid, unsigned threads);

/// Builds the corners. A singular vertex takes the limits of its cells, or the normal of a cell's
/// face where the cell has no limit. Adds the singular points and the evaluations to `report`.
Corners make_corners(const Surface& surface, const Grid& grid, std::span<const dvec3> normals,
                     unsigned threads, MeshReport& report);

}  // namespace saddle
