// Distances of triangles between points of the surface from the triangles of the mesh below them.
#pragma once

#include <array>
#include <span>

#include "mesh/grid/grid.h"

namespace saddle {

/// Whether it is proved that no point of the triangle with these corners is farther than `most`
/// from triangles of the mesh. These are projected straight onto its plane, and have to lie the
/// same way up there.
bool is_over(const std::array<dvec3, 3>& corners, const Grid& grid,
             std::span<const Triangle> triangles, double most);

}  // namespace saddle
