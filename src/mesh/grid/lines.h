// Grid lines of a scene as chains of mesh edges.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "mesh/grid/grid.h"

namespace saddle {

/// Chains of vertices along lines.
class ChainBuilder {
 public:
  explicit ChainBuilder(const Mesh& mesh) : point_(mesh.point) {}

  /// Goes on to a vertex, unless it is the same point as the last one.
  void append(std::uint32_t vertex);
  /// Ends the chain. Chains of one vertex are dropped.
  void interrupt();
  std::vector<std::vector<std::uint32_t>> take() { return std::move(chains_); }

 private:
  const Array<std::uint32_t>& point_;
  std::vector<std::uint32_t> chain_;
  std::vector<std::vector<std::uint32_t>> chains_;
};

/// Some of the grid's lines of constant u and of constant v. A line runs along the edges of cells
/// that have triangles; an interrupted line is several chains. Edges that are a single point, as at
/// a pole, are left out. Lines go through the vertices' own corners, used or not.
std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid,
                                                   const std::vector<std::size_t>& columns,
                                                   const std::vector<std::size_t>& rows);

}  // namespace saddle
