// A mesh within a tolerance from a tensor grid alone, which Method::LeastCost tries first. Where
// curvature varies little, it has about as many triangles as a cell tree for a fraction of the
// work.
#pragma once

#include <optional>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// The result of a trial: a mesh, or why there is none.
struct GridTrial {
  std::optional<MeshResult> mesh;  ///< empty: the grid misses the tolerance or is not smooth
  /// The largest error in tolerances, if the grid misses; 0 if closer lines would not help.
  double excess = 0;
  MeshWork work;
};

/// Makes the mesh of the grid of these lines, and checks it at validation points and by interval
/// bounds. There is no mesh if a cell exceeds the tolerance, or if the surface is not smooth and
/// regular, except at sides that are a single point: mesh_within_tolerance() handles those.
GridTrial try_grid(const Surface& surface, const MeshRequest& request, const MeshPlan& plan,
                   FixedLines lines);

}  // namespace saddle
