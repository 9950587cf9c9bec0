// Tessellation within a tolerance, with as few triangles as that needs: a tensor grid whose lines
// are as close as curvature asks, and cells halved where that is not enough.
#pragma once

#include <optional>

#include "mesh/mesher/mesh_plan.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Tessellates a surface of second order. Cells that the boundary of the surface crosses are
/// clipped at it. Nothing if there is no plan, no cell of the root grid is defined or no triangle
/// has any area: mesh_on_grid() deals with those. Throws Error (Nothing) as mesh_on_grid() does.
std::optional<MeshResult> mesh_within_tolerance(const Surface& surface, const MeshRequest& request);
/// The same, as planned.
std::optional<MeshResult> mesh_within_tolerance(const Surface& surface, const MeshRequest& request,
                                                MeshPlan plan);

}  // namespace saddle
