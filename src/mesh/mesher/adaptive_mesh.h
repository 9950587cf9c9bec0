// Way of meshing 1 of 3 (mesher.h): a mesh within a tolerance from a cell tree. A sizing field
// places the root lines; leaves are subdivided where that is not enough.
#pragma once

#include <optional>

#include "mesh/mesher/mesh_plan.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Tessellates a surface with second derivatives. Empty if there is no plan, no cell of the root
/// grid is defined, or no triangle has an area: mesh_uniformly() handles these surfaces. Throws
/// Error (Nothing) as mesh_on_grid() does.
std::optional<MeshResult> mesh_within_tolerance(const Surface& surface, const MeshRequest& request);
/// The same from a plan.
std::optional<MeshResult> mesh_within_tolerance(const Surface& surface, const MeshRequest& request,
                                                MeshPlan plan);

}  // namespace saddle
