#include "mesh/grid/lines.h"

namespace saddle {

namespace {

/// Follows `line` edge by edge. `exists(k)`: edge k, k + 1 is in the mesh.
template <class Exists>
void append_chains(const Grid& grid, const GridLine& line, Exists exists, ChainBuilder& chains) {
  for (std::size_t k = 0; k + 1 < line.count; ++k) {
    const auto a = static_cast<std::uint32_t>(line[k]);
    const auto b = static_cast<std::uint32_t>(line[k + 1]);
    if (!exists(k)) {
      chains.interrupt();
    } else if (grid.mesh.point[a] != grid.mesh.point[b]) {
      chains.append(a);
      chains.append(b);
    }
  }
  chains.interrupt();
}

}  // namespace

void ChainBuilder::append(std::uint32_t vertex) {
  const bool repeats = !chain_.empty() && point_[chain_.back()] == point_[vertex];
  if (!repeats) chain_.push_back(vertex);
}

void ChainBuilder::interrupt() {
  if (chain_.size() > 1) chains_.push_back(chain_);
  chain_.clear();
}

std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid,
                                                   const std::vector<std::size_t>& columns,
                                                   const std::vector<std::size_t>& rows) {
  const auto has_triangles = [&](std::size_t i, std::size_t j) {
    return i < grid.cells_u && j < grid.cells_v && grid.triangle_count(grid.cell(i, j)) > 0;
  };
  ChainBuilder chains(grid.mesh);
  for (const std::size_t i : columns) {
    // Left of column 0 is column -1, which wraps around to a huge number and is no cell.
    const auto exists = [&](std::size_t j) {
      return has_triangles(i, j) || has_triangles(i - 1, j);
    };
    append_chains(grid, grid.column(i), exists, chains);
  }
  for (const std::size_t j : rows) {
    const auto exists = [&](std::size_t i) {
      return has_triangles(i, j) || has_triangles(i, j - 1);
    };
    append_chains(grid, grid.row(j), exists, chains);
  }
  return chains.take();
}

}  // namespace saddle
