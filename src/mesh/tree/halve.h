// The binary trees of the forest: their roots and the halving of a leaf.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct Grid;

/// Cells [first, end) of the root grid.
std::vector<Leaf> root_leaves(const Grid& grid, std::size_t first, std::size_t end);

/// The two halves of a leaf whose samples are known; their new corners go into use. Empty if the
/// leaf is one unit wide.
std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool along_u, CellTree& tree);

/// Whether the surface is defined at a vertex of a leaf's cell polygon.
bool has_defined_corner(const Leaf& leaf, const CellTree& tree);

}  // namespace saddle
