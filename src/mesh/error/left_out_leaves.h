// Leaves without triangles: the features of each are too near to each other to be told apart, or
// one is a pole's.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "mesh/distance/whole_mesh_error.h"
#include "mesh/error/validated_mesh.h"

namespace saddle {

class CellTree;
struct Grid;

/// A leaf without triangles, and the place of its sheets that is farthest from the mesh.
struct LeftOutLeaf {
  std::size_t leaf;
  PlacedError farthest;
};

/// Measures the sheets in all leaves that are too small for triangles, where they meet the sides
/// and half way across, and inside where a jump meets the boundary or another jump, from the other
/// leaves' triangles. Places outside of `clip` have no error.
std::vector<LeftOutLeaf> measure_too_small(const ValidatedMesh& mesh, const Grid& grid,
                                           const std::optional<Bounds>& clip, unsigned threads,
                                           const CellTree& tree);

/// The same, for a mesh that is done: also inside of the largest leaves that their features leave
/// without triangles, but for those at a pole that nothing clips, and where needles toward poles
/// leave `clip`. Distances of less than half of what is `known` may be too large, up to that.
std::vector<LeftOutLeaf> measure_left_out(const ValidatedMesh& mesh, double known, const Grid& grid,
                                          const std::optional<Bounds>& clip, unsigned threads,
                                          const CellTree& tree);

}  // namespace saddle
