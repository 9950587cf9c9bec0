// Corners at singular points whose normals face away from their own triangle.
#pragma once

#include <cstdint>
#include <functional>

#include "mesh/model/mesh.h"
#include "surface/surface.h"

namespace saddle {

/// Gives each triangle that opposes the normal of a singular corner, by more than a right angle, a
/// corner of its own at the same point. Its normal is the surface's at the nearest place within the
/// triangle from which it faces as the triangle does. Neighbours share the corner.
/// Corners that `is_singular` does not hold for keep their normals, which are the formula's.
/// Triangles that all corners oppose alike, or that the surface faces nowhere, are slivers thinner
/// than what may be missing, whose planes tell nothing: they keep their corners.
void face_own_triangles(const Surface& surface, unsigned threads,
                        const std::function<bool(std::uint32_t)>& is_singular, Mesh& mesh);

}  // namespace saddle
