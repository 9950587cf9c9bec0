// From the leaves of a refined grid to triangles and lines.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/model/mesh_report.h"
#include "mesh/tree/cell_polygon.h"
#include "surface/normal.h"

namespace saddle {

/// Triangles of some leaves.
struct LeafTriangles {
  /// Those of one leaf among all.
  struct Range {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
    std::uint32_t expected = 0;  ///< if none were without area
    bool is_plain = false;       ///< of a leaf that nothing cuts, and two triangles
    bool has_flat_sub_polygon =
        false;  ///< one of the pieces that cuts left of it is a side of the leaf
  };
  Array<Triangle> all;
  std::vector<Range> ranges;

  std::span<const Triangle> of(std::size_t k) const {
    return std::span(all).subspan(ranges[k].first, ranges[k].count);
  }
  std::size_t expected() const;
};

/// The limits of normals that were asked for last: most meshes do not change any more between the
/// time that their leaves are measured with them and the time that they become theirs.
class LastLimits {
 public:
  /// limits_in_cells().
  const std::vector<NormalLimit>& find(const Surface& surface, std::vector<Approach> approaches,
                                       unsigned threads);

 private:
  std::vector<Approach> approaches_;
  std::vector<NormalLimit> limits_;
};

/// Corners that leaves have of their own at singular vertices; regular vertices are one corner.
class SingularCorners {
 public:
  SingularCorners() = default;
  /// Gives each singular vertex of each piece of a leaf the limit of the normal from inside the
  /// piece, or the normal of its face where there is none. Adds corners to grid.mesh, singular
  /// points to `report`.
  SingularCorners(std::span<const Leaf> leaves, const CellTree& tree, unsigned threads,
                  LastLimits& last, Grid& grid, MeshReport& report);

  /// `piece`: the number of one of the leaf's pieces().
  std::uint32_t corner(std::size_t leaf, std::size_t sub_polygon, std::uint32_t vertex) const;
  /// The leaves that have such corners, ascending.
  const std::vector<std::size_t>& leaves() const { return leaves_; }

 private:
  std::vector<std::size_t> leaves_;
  std::unordered_map<std::uint64_t, std::uint32_t> corners_;
};

/// Triangulates some leaves, each with all the vertices in use on its sides.
LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, std::span<const std::size_t> which,
                                 const SingularCorners& singular, const Grid& grid,
                                 const CellTree& tree);

/// Lines of constant u and v through vertices, those of even_lines(), which are lines of the grid.
/// They are interrupted where the surface is, and where it oscillates: from wave to wave they would
/// cover it, and take longer to draw than all else.
std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const CellTree& tree,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v);

}  // namespace saddle
