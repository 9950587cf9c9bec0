// Tessellation within a tolerance, with as few triangles as that needs: a tensor grid whose lines
// are as close as curvature asks, and cells halved where that is not enough.
#pragma once

#include <functional>
#include <optional>

#include "mesh/density.h"
#include "mesh/grid_mesh.h"
#include "surface/surface.h"

namespace saddle {

struct AdaptiveOptions {
  /// The tolerance, once it is known about where the surface is.
  std::function<Tolerance(const Probe&)> tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  /// The mesh is cut along this box; its faces may be infinitely far.
  std::optional<Bounds> clip = {};
  /// Lines of constant u and of constant v, evenly spaced, first and last on the ends of the range;
  /// 0: none. They are among the mesh's edges.
  int lines_u = 16;
  int lines_v = 16;
  bool certify = true;   ///< prove that nothing hides between samples, as far as that goes
  unsigned threads = 0;  ///< 0: all
};

/// Tessellates a surface of second order. Cells that the rim of the surface crosses are clipped at
/// it. Nothing if no cell of the root grid is defined, no triangle has any area, or the surface is
/// so large or small that its tolerance is not a positive number: mesh_on_grid() deals with those.
/// Throws Error (Nothing) as mesh_on_grid() does.
std::optional<GridMesh> mesh_within_tolerance(const Surface& surface,
                                              const AdaptiveOptions& options);

}  // namespace saddle
