// Solves for the places inside of leaves where features cross, end or turn.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"

namespace saddle {

class CellTree;

/// Gives the sheets in some leaves vertices where features cross, end or turn; on a smooth line
/// that is too far from its chord, where it is farthest. Returns the leaves that got any,
/// ascending. Where none is found, as between two separate lines, the leaf stays as it is.
std::vector<std::size_t> solve_inner_vertices(std::span<const std::size_t> which,
                                              const CellLimits& limits, ValidatedMesh& mesh,
                                              CellTree& tree);

}  // namespace saddle
