// Way of meshing 2 of 4 (mesher.h), MeshRequest::Method::LeastCost: a grid (grid_within.h) or a
// cell tree (adaptive_mesh.h), whichever is cheaper by the cost model.
#pragma once

#include <optional>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// Tessellates a surface with second derivatives within the tolerance. The cost
/// (mesh/sizing/cost_model.h) is that of making the mesh once and drawing it request.draws times. A
/// grid that misses the tolerance gets closer lines while it stays cheaper. The report's `choice`
/// tells the method and the reason. Empty, and throws, as mesh_within_tolerance() does.
std::optional<MeshResult> mesh_at_least_cost(const Surface& surface, const MeshRequest& request);

}  // namespace saddle
