// The mesher: from a surface and a request to a mesh and its report.
//
// A forest of binary trees over a tensor grid of parameters covers the domain. Cells are subdivided
// until error indicators, validation points and interval bounds find nothing more; each leaf is cut
// along the boundaries, jumps, poles and creases in it, and its polygon is triangulated. Hanging
// vertices are corners of these polygons. There are three ways of meshing:
//   adaptive_mesh  a cell tree within the tolerance, with few triangles
//   sampled_mesh   a given number of cells, cut along edge features, not subdivided
//   grid_mesh      a uniform grid, for surfaces that the others cannot mesh
// ../README.md describes the mesher on one page. A mesh within a thousandth of the diagonal:
//   MeshRequest request;
//   request.tolerance = [](const Probe& probe) { return 1e-3 * probe.bounds().diagonal(); };
//   std::optional<MeshResult> result = try_mesh(surface, request);
// By samples, the mesh is within it if report.max_error <= *report.tolerance. If report.certified,
// bounds prove the mesh to be within four tolerances. report.reached_limit: a limit came first.
#pragma once

#include <optional>

#include "mesh/mesher/grid_mesh.h"
#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "mesh/sizing/probe.h"
#include "surface/surface.h"

namespace saddle {

/// Meshes a surface with second derivatives. Empty if the diagonal of
/// the surface is not a normal number, if the mesh would need more lines than can be numbered, if
/// no cell is defined, or if no triangle has an area. Throws Error (Nothing) if the surface is
/// undefined everywhere, a point or a curve; the message says which. `report.evaluations` counts
/// all points at which the surface was evaluated.
std::optional<MeshResult> try_mesh(const Surface& surface, const MeshRequest& request);

/// try_mesh(), or mesh_uniformly() where try_mesh() has no mesh.
MeshResult make_mesh(const Surface& surface, const MeshRequest& request,
                     const UniformRequest& fallback);

}  // namespace saddle
