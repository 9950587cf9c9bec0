// Tessellation by a uniform grid of cells in the parameter rectangle.
#pragma once

#include <optional>

#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

struct GridOptions {
  int cells_u = 100;  ///< cells in u and v, at least 1 each
  int cells_v = 100;
  /// Lines of constant u and of constant v, evenly spaced, first and last on the ends of the
  /// range; 0: none. A line that falls between mesh lines follows the nearest one.
  int lines_u = 16;
  int lines_v = 16;
  unsigned threads = 0;  ///< 0: all
};

/// Tessellates `surface`. Cells with an undefined corner are left out and counted. Throws Error:
/// Nothing if the surface is undefined everywhere, or is a point or a curve; the message says
/// which.
MeshResult mesh_on_grid(const Surface& surface, const GridOptions& options);

/// How fine the cells of mesh_uniformly() are: halved until errors are within `share` of the
/// diagonal, or halving does not help. Without a share they are not halved.
struct UniformRequest {
  GridOptions grid;
  std::optional<double> share;
  std::optional<Bounds> clip;  ///< the mesh is cut along this box
};

/// mesh_on_grid() with cells fine enough, cut along the box. For surfaces that no other method can
/// mesh. Throws as mesh_on_grid() does, and as clip_mesh().
MeshResult mesh_uniformly(const Surface& surface, const UniformRequest& request);

}  // namespace saddle
