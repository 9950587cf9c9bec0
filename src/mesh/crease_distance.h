// How far triangles beside creases and cusps are from the surface: there what is nearest to a point
// is not what is at its parameters.
#pragma once

#include <span>
#include <vector>

#include "mesh/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Where lines in the (u, v) plane are crossed by cusps, or by creases at which the surface is
/// upright; the middle of a line that none crosses.
std::vector<dvec2> crease_places(const Surface& surface, std::span<const Line> lines,
                                 unsigned threads);

/// A point of the mesh.
struct MeshPoint {
  dvec3 position;
  dvec2 uv;     ///< parameters that the mesh has there
  dvec2 reach;  ///< how far away the nearest point of the surface is looked for
};
/// The distances of points of the mesh from the surface near their parameters, or a little more.
/// Source: D. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", 1963.
std::vector<double> distances_from_surface(const Surface& surface,
                                           std::span<const MeshPoint> points, unsigned threads);

}  // namespace saddle
