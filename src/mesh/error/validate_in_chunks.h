// Validates leaves of a mesh, some at a time on several threads.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

class CellTree;

/// The cost of a validation.
struct ValidationCost {
  std::size_t evaluations = 0;
  /// Points and boxes in searches, which cost more the longer the formula is.
  std::size_t looks = 0;
};

/// Leaves of a mesh by their numbers, and their triangles: one range for each.
struct LeavesToValidate {
  std::span<const std::size_t> which;
  const LeafTriangles& triangles;
};

/// Measures leaves against their triangles by mesh/error/validator.h; and, at
/// the faces of the clip box, against the triangles of all leaves. Leaves for which no work is left
/// have no sampled errors.
ValidationCost validate_in_chunks(const Surface& surface, const Grid& grid, const CellTree& tree,
                                  const CellLimits& limits, const LeavesToValidate& leaves,
                                  ValidatedMesh& mesh);

}  // namespace saddle
