// The mesh of a uniform grid, with the care that a mesh within a tolerance takes of boundaries,
// jumps, poles and creases, but no cell is halved.
#pragma once

#include <optional>

#include "mesh/mesher/adaptive_mesh.h"
#include "mesh/model/mesh_report.h"

namespace saddle {

/// Tessellates a surface of second order by cells_u x cells_v cells, two triangles each where
/// nothing cuts them. Cells that the boundary, a jump or a crease goes through are cut along it;
/// one in which the surface goes to infinity is left out. The tolerance of `options` tells jumps
/// from slopes; it is not kept. Nothing as plan_mesh() does, and where no cell is left:
/// mesh_on_grid() deals with those.
std::optional<MeshResult> mesh_of_samples(const Surface& surface, const AdaptiveOptions& options,
                                          std::size_t cells_u, std::size_t cells_v);

}  // namespace saddle
