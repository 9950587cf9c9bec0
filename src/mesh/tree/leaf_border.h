// The length of the border of a leaf, without what its features cut off.
#pragma once

#include <optional>

#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// The length of the pieces of surface around a leaf, between its features. Nothing if no side
/// along u, or none along v, is known to have one feature at most: unless it is too short to halve.
std::optional<double> border_of_pieces(const Leaf& leaf, const CellTree& tree);

}  // namespace saddle
