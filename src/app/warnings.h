// What a user would otherwise be misled about.
#pragma once

#include <string>
#include <vector>

#include "mesh/grid_mesh.h"
#include "surface/surface.h"

namespace saddle {

/// One sentence per kind of finding, with its count.
std::vector<std::string> mesh_warnings(const std::string& name, const GridMesh& grid_mesh,
                                       const Domain& domain);

/// That the mesh is farther from the surface than `tolerance`, and by how much.
std::string coarse_warning(const std::string& name, const MeshReport& report, double tolerance);

}  // namespace saddle
