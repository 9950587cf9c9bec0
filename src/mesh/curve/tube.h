// Meshes of curves: lines, and tubes.
#pragma once

#include "mesh/curve/curve_mesher.h"
#include "mesh/model/mesh.h"

namespace saddle {

/// A mesh without triangles whose lines are the curve's chains. Corners have (s, 0) as u and v.
Mesh line_mesh(const CurveMesh& curve);

/// The surface of all balls of this radius (more than 0) round points of the curve: tubes with half
/// a ball at each end, and a joint where the curve has a corner; closed where the curve is. Corners
/// lie on it exactly, with its normals, and have (s, angle) as u and v. Between them the mesh is
/// within `tolerance` of the tube, as far as the chains are within half of it.
/// Rings are not twisted against each other, also where the curve is straight or inflects.
/// Source: W. Wang, B. Juettler, D. Zheng, Y. Liu, "Computation of rotation minimizing frames",
/// 2008.
Mesh tube_mesh(const CurveMesh& curve, double radius, double tolerance);

}  // namespace saddle
