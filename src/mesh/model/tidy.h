// The last step of every mesh: removes corners and point numbers that no triangle uses.
#pragma once

#include "mesh/model/mesh.h"

namespace saddle {

/// Numbers the points from 0 without gaps. Before, a point's number is that of one of its corners.
void number_points(Mesh& mesh);

/// Removes the corners that no triangle uses. Lines then go through other corners of the same
/// points: at a pole triangles may use only some. Recomputes the bounds, then number_points().
void keep_used_corners(Mesh& mesh);

}  // namespace saddle
