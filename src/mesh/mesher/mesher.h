// The mesher: from a surface and a request to a mesh and its report.
//
// A forest of binary trees over a tensor grid of parameters covers the domain. Cells are subdivided
// until error indicators, validation points and interval bounds find nothing more; each leaf is cut
// along the boundaries, jumps, poles and creases in it, and its polygon is triangulated. Hanging
// vertices are corners of these polygons. A grid without subdivided cells, where it is enough, is
// the same at less cost. ../README.md has the whole story on one page.
#pragma once

#include <optional>

#include "mesh/mesher/grid_mesh.h"
#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "mesh/sizing/probe.h"
#include "surface/surface.h"

namespace saddle {

/// Meshes a surface of second order by the method of the request. Nothing where there is no such
/// mesh: the surface's size is no normal number, it would take more lines than can be numbered, no
/// cell is defined, or no triangle has any area. Throws Error (Nothing) if the surface is undefined
/// everywhere, a point or a curve; the message says which. `report.evaluations` counts every point
/// of the surface that was computed meanwhile.
std::optional<MeshResult> try_mesh(const Surface& surface, const MeshRequest& request);

/// try_mesh(), or the uniform mesh where that has none.
MeshResult make_mesh(const Surface& surface, const MeshRequest& request,
                     const UniformRequest& fallback);

}  // namespace saddle
