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

/// Cuts the sides that are known to lead to poles, and follows their features; uncut, they would be
/// walls to far vertices. With `search`, searches unsearched sides of leaves above tolerance, too,
/// or of all leaves if there are poles and no clip box.
void cut_walls(const CellLimits& limits, bool search, CellTree& tree, ValidatedMesh& mesh);

}  // namespace saddle
