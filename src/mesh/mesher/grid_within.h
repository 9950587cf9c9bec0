// Tessellation within a tolerance by a grid alone: where curvature is much the same everywhere it
// takes about as many triangles as halving cells, for a fraction of the work.
#pragma once

#include <optional>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// What came of a grid.
struct GridTrial {
  std::optional<MeshResult> mesh;  ///< if it keeps the tolerance
  /// By how much it does not, in tolerances, where closer lines would help; else 0.
  double excess = 0;
  MeshWork work;
};

/// Makes the mesh of the grid of these lines and verifies it like any mesh within a tolerance: on
/// fresh points, and by bounds. There is none if the surface is not smooth and regular everywhere,
/// poles of its parameters apart, or some cell is farther off than allowed: mesh_within_tolerance()
/// deals with those.
GridTrial try_grid(const Surface& surface, const MeshRequest& request, const MeshPlan& plan,
                   FixedLines lines);

}  // namespace saddle
