// Warnings about a mesh that would otherwise mislead.
#pragma once

#include <string>
#include <vector>

#include "mesh/color/color_mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// One sentence per kind of finding, with its count.
std::vector<std::string> mesh_warnings(const std::string& name, const MeshResult& grid_mesh,
                                       const Domain& domain);

/// The same about its colour.
std::vector<std::string> color_warnings(const std::string& name, const Mesh& mesh,
                                        const ColorReport& report);

/// Where the surface is defined: the box around the mesh's parameters, if it is smaller than the
/// domain, else only that it is in places.
std::string where_defined(const Mesh& mesh, const Domain& domain);

}  // namespace saddle
