// Way of meshing 3 of 3 (mesher.h), the fallback of make_mesh(): a uniform grid of cells, for
// surfaces that the others cannot mesh.
#pragma once

#include <optional>

#include "mesh/model/mesh_report.h"
#include "surface/surface.h"

namespace saddle {

struct GridOptions {
  int cells_u = 100;  ///< cells in u and v, at least 1 each
  int cells_v = 100;
  /// Drawn lines of constant u and of constant v, evenly spaced from end to end of the range; 0:
  /// none. A line between mesh lines follows the nearest one.
  int lines_u = 16;
  int lines_v = 16;
  unsigned threads = 0;  ///< 0: all
};

/// Tessellates a surface by a uniform grid. Cells with an undefined corner are left out and
/// counted. Throws Error (Nothing) if the surface is undefined everywhere, a point or a curve; the
/// message says which.
MeshResult mesh_on_grid(const Surface& surface, const GridOptions& options);

/// The cells of mesh_uniformly() are halved until the error is at most `share` of the diagonal, or
/// two halvings in a row did not help, or there would be more than kMostGridCells. Without a share
/// they are not halved.
struct UniformRequest {
  GridOptions grid;
  std::optional<double> share;
  std::optional<Bounds> clip;  ///< the mesh is cut along this box
};

/// mesh_on_grid() with cells of the requested size, cut along the clip box. Throws as
/// mesh_on_grid() and clip_mesh() do.
MeshResult mesh_uniformly(const Surface& surface, const UniformRequest& request);

}  // namespace saddle
