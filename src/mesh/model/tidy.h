// The last step of every mesh: what its arrays hold is what its triangles use.
#pragma once

#include "mesh/model/mesh.h"

namespace saddle {

/// Numbers the points from 0 without gaps; before, a point is named after one of its corners.
void number_points(Mesh& mesh);

/// Leaves out the corners that no triangle uses, and has lines go through others of the same points
/// (at a pole triangles may use only some of its corners). Bounds become those of what is left.
/// Then number_points().
void keep_used_corners(Mesh& mesh);

}  // namespace saddle
