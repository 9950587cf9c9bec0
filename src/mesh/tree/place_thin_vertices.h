// Gives the sides of leaves a vertex in each of their thin parts, so that slots and slits narrower
// than a leaf cut its polygon.
#pragma once

#include <span>

#include "mesh/model/tolerance.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Searches the sides of leaves whose samples are known, each side once. A part narrower than the
/// last units of the cell tree gets none, nor does a gap narrower than the tolerance.
void place_thin_vertices(std::span<const Leaf> leaves, const Tolerance& tolerance, unsigned threads,
                         CellTree& tree);

}  // namespace saddle
