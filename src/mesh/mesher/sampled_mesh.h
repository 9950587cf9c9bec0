// Way of meshing 2 of 3 (mesher.h): a given number of cells, cut along boundaries, jumps, poles and
// creases, not subdivided.
#pragma once

#include <optional>

#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Tessellates a surface with second derivatives by the cells of request.samples, which is set. A
/// cell without edge features has two triangles. A cell with a boundary, a jump or a crease is cut
/// along it; a cell with a pole is left out. Errors are measured as those of halved cells are,
/// except in more than 65,536 cells of a smooth surface. Empty as plan_mesh() is, and if no cell is
/// left.
std::optional<MeshResult> mesh_of_samples(const Surface& surface, const MeshRequest& request);

}  // namespace saddle
