// From the leaves of a refined grid to triangles, seams and lines.
#pragma once

#include <array>
#include <span>
#include <unordered_map>
#include <vector>

#include "mesh/lattice.h"
#include "mesh/weld.h"

namespace saddle {

/// Triangles of leaf k: all[first[k]] to all[first[k + 1] - 1].
struct LeafTriangles {
  Array<Triangle> all;
  std::vector<std::uint32_t> first;
  std::size_t expected = 0;  ///< triangles if none were without area

  std::span<const Triangle> of(std::size_t leaf) const {
    return std::span(all).subspan(first[leaf], first[leaf + 1] - first[leaf]);
  }
};

/// Corners that leaves have of their own at singular vertices; regular vertices are one corner.
class SingularCorners {
 public:
  SingularCorners() = default;
  /// Gives each singular vertex of each leaf the limit of the normal from inside the leaf, or the
  /// leaf's face normal where there is none. Adds corners to grid.mesh, singular points and
  /// evaluations to `report`.
  SingularCorners(const Surface& surface, std::span<const Leaf> leaves, const Lattice& lattice,
                  unsigned threads, Grid& grid, MeshReport& report);

  std::uint32_t corner(std::size_t leaf, std::uint32_t vertex) const;
  /// The leaves that have such corners, ascending.
  const std::vector<std::size_t>& leaves() const { return leaves_; }

 private:
  std::vector<std::size_t> leaves_;
  std::unordered_map<std::uint64_t, std::uint32_t> corners_;
};

/// The pairs of neighbours among the vertices in use around a leaf.
using Side = std::array<std::uint32_t, 2>;
std::vector<Side> sides_of(const Leaf& leaf, const Lattice& lattice);

/// Triangulates every leaf with all the vertices in use on its sides.
LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, const SingularCorners& singular,
                                 const Grid& grid, const Lattice& lattice);

/// Puts the vertices in use on one side of each seam into use on the other, and makes both one
/// point with bitwise equal positions. Root vertices are welded already.
void mirror_seams(const Seams& seams, unsigned threads, Grid& grid, Lattice& lattice);

/// Finds the vertices on the rim of the surface on the sides of leaves that it crosses.
void fit_rims(std::span<const Leaf> leaves, unsigned threads, Lattice& lattice);

/// Makes neighbours on the sides of leaves that are at the same place one singular point: poles
/// that no line of the root grid goes through.
void join_poles(std::span<const Leaf> leaves, const Grid& grid, Lattice& lattice);

/// Lines of constant u and v through vertices, those of even_lines(), which are lines of the grid.
/// They are interrupted where the surface is.
std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const Lattice& lattice,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v);

}  // namespace saddle
