// Singular places of the parameters as points of space: a whole line of places is one pole.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

/// Positions at singular places: where the surface is not defined, the limit that its mesh has.
std::vector<dvec3> singular_positions(const Surface& surface, const Mesh& mesh,
                                      std::span<const dvec2> places);

/// The points of space at the report's singular places and along its singular lines.
std::vector<SingularInSpace> singular_in_space(const Surface& surface, const Mesh& mesh,
                                               const MeshReport& report);

}  // namespace saddle
