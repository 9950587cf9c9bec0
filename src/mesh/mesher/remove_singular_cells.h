// What halving does not help is cut out of a mesh: points and lines at which the surface goes to
// infinity, and points at which it has no limit.
#pragma once

#include <optional>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/features/point_singularities.h"

namespace saddle {

class CellTree;

/// A point at which the surface is not defined, or jumps.
struct PlacedSingularity {
  dvec2 uv;
  PointSingularity singularity;
};

/// Whether nothing of a leaf is within a box, if there is one.
bool is_clipped(const Leaf& leaf, const std::optional<Bounds>& clip, const CellTree& tree);

/// Leaves out those leaves in which the surface goes to infinity at a point, or has no limit there.
/// Returns these points, each of them once.
std::vector<PlacedSingularity> leave_out_singularities(const Surface& surface,
                                                       const CellLimits& limits,
                                                       const CellTree& tree, ValidatedMesh& mesh);

/// Cuts the sides of leaves that lead to poles, which would be walls, where that is known or is
/// found by following the poles from leaf to leaf. If `search`, those too that do beside a boundary
/// or a jump, and all others of leaves that halving did not help or, of a surface that has poles
/// and is not clipped, of any.
void cut_walls(const CellLimits& limits, bool search, CellTree& tree, ValidatedMesh& mesh);

}  // namespace saddle
