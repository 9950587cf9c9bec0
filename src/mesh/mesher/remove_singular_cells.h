// Removes singular cells, which no halving resolves: leaves at poles and at essential points, and
// the walls that poles along a line would leave.
#pragma once

#include <optional>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/features/point_singularities.h"

namespace saddle {

class CellTree;

/// A point singularity and its place.
struct PlacedSingularity {
  dvec2 uv;
  PointSingularity singularity;
};

/// Whether all of a leaf is outside of the clip box; false without one.
bool is_clipped(const Leaf& leaf, const std::optional<Bounds>& clip, const CellTree& tree);

/// Leaves out the leaves with a pole or an essential point inside. Returns these points, each once.
/// Accepts the leaves within the tolerance of an essential point.
std::vector<PlacedSingularity> leave_out_singularities(const Surface& surface,
                                                       const CellLimits& limits,
                                                       const CellTree& tree, ValidatedMesh& mesh);

/// Cuts the sides of leaves that lead to poles; uncut, they would be walls to far vertices. The
/// poles are known or found by following features. With `search`, other sides are searched too:
/// those with a boundary or a jump, those of failed leaves, and all if poles are not clipped.
void cut_walls(const CellLimits& limits, bool search, CellTree& tree, ValidatedMesh& mesh);

}  // namespace saddle
