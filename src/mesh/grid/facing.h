// Corners whose normals face away from their own triangle: beyond a bend sharper than the
// tolerance, or at a point with several limits.
#pragma once

#include <cstddef>

#include "mesh/model/mesh.h"
#include "surface/surface.h"

namespace saddle {

/// Gives triangles that a corner's normal opposes, by more than a right angle, a corner of their
/// own at the same point, as at a crease: with the surface's normal from within the triangle, at
/// the place nearest to the corner from which it faces as the triangle does. Neighbours share it.
/// Triangles that all corners oppose alike, or that the surface faces nowhere, are slivers thinner
/// than what may be missing, whose planes tell nothing: they keep their corners.
void face_own_triangles(const Surface& surface, unsigned threads, Mesh& mesh);

}  // namespace saddle
