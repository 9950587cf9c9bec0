// Grid lines of a scene as chains of mesh edges.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/grid.h"
#include "mesh/triangulate.h"

namespace saddle {

/// What lines are made of: by vertex of the grid.
struct LineVertices {
  std::span<const std::uint32_t> point;   ///< see Joints
  std::span<const std::uint32_t> corner;  ///< a corner there, or kNoCorner
};

inline constexpr std::uint32_t kNoCorner = 0xffffffff;

/// options.lines_u lines of constant u and options.lines_v of constant v. A line runs along the
/// edges of cells that have triangles, and is several chains where it is interrupted. Edges that
/// are a single point (the lines of constant latitude at a pole) are left out.
std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid, const CellTriangles& triangles,
                                                   const LineVertices& vertices,
                                                   const GridOptions& options);

}  // namespace saddle
