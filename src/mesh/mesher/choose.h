// The cheapest of the meshes that keep a tolerance: a grid, or cells halved where they need it.
#pragma once

#include <optional>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// Tessellates a surface of second order within the tolerance, by the method that costs least by
/// the model (mesh/sizing/cost_model.h): making the mesh, and drawing it so many `times`. A grid
/// that turns out to miss the tolerance is made anew with closer lines, if that still costs less,
/// or given up. The report's `choice` says which method it was and why. Nothing, and errors, as
/// those of mesh_within_tolerance().
std::optional<MeshResult> mesh_at_least_cost(const Surface& surface, const MeshRequest& request);

}  // namespace saddle
