// A mesh of a given number of cells, cut along boundaries, jumps, poles and creases.
#pragma once

#include <optional>

#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Tessellates a surface of second order by the cells of request.samples, which is set: two
/// triangles each where nothing cuts them. Cells that a boundary, a jump or a crease crosses are
/// cut along it; a cell in which the surface goes to infinity is left out. Nothing as plan_mesh()
/// does, and where no cell is left.
std::optional<MeshResult> mesh_of_samples(const Surface& surface, const MeshRequest& request);

}  // namespace saddle
