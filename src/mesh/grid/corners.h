// The corners of open cells. A regular vertex is one corner; a singular one has a corner for each
// different one-sided limit of the normal among the cells around it.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/grid/grid.h"
#include "mesh/model/mesh_report.h"
#include "surface/normal.h"

namespace saddle {

/// The corners of one singular vertex after the other.
class VertexCorners {
 public:
  explicit VertexCorners(Mesh& mesh) : mesh_(mesh) {}

  /// Starts a vertex, which has no normal yet.
  void begin(std::size_t vertex);
  /// A corner of the vertex with this normal, to kCreaseDegrees: its own, if that is still free, or
  /// an earlier one, or a new one at the end of the mesh.
  std::size_t find_or_add(const dvec3& normal);

 private:
  Mesh& mesh_;
  std::size_t vertex_ = 0;
  bool own_is_free_ = true;
  std::size_t first_new_ = 0;
};

/// Adds a corner at the same point as `like`, with a normal of its own. Returns its number.
std::uint32_t add_corner(Mesh& mesh, std::size_t like, const dvec3& normal);

/// The unit normal on the front of a face with this vector area, by the order of the cells' slots;
/// zero if it has none.
dvec3 front_normal(const Grid& grid, const dvec3& area);

/// limit_normals() within cells. A corner at which the surface is not defined is approached aslant:
/// along a cell's diagonal the formula may be 0/0, and beside it mere rounding.
std::vector<NormalLimit> limits_in_cells(const Surface& surface, std::vector<Approach> approaches,
                                         unsigned threads);

/// A cell to cut, with the corners of its four slots.
struct OpenCell {
  std::size_t cell;
  std::array<std::uint32_t, 4> corners;
};

/// Lists the open cells. A singular vertex takes the limits of its cells, or the normal of a cell's
/// face where the cell has no limit: the first is the vertex's own, others are new corners at the
/// end of grid.mesh (zero if the cell has no area either). Adds the singular points to
/// `report`.
std::vector<OpenCell> open_cells(const Surface& surface, unsigned threads, Grid& grid,
                                 MeshReport& report);

}  // namespace saddle
