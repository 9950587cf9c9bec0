// Parameter lines drawn on a mesh of leaves.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct Grid;

/// Chains of vertices along lines of constant u and v: the lines of the root grid that are nearest
/// to even_lines(). A chain ends where the surface is interrupted and where it oscillates: a line
/// through all waves would cover the surface and take longer to draw than the rest.
std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const CellTree& tree,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v);

}  // namespace saddle
