#include "mesh/grid/lines.h"

namespace saddle {

namespace {

using Chain = std::vector<std::uint32_t>;

/// Follows `line` edge by edge and appends its chains. `exists(k)`: edge k, k + 1 is in the mesh.
template <class Exists>
void append_chains(const Grid& grid, const GridLine& line, Exists exists,
                   std::vector<Chain>& chains) {
  Chain chain;
  const auto finish = [&] {
    if (chain.size() > 1) chains.push_back(chain);
    chain.clear();
  };
  for (std::size_t k = 0; k + 1 < line.count; ++k) {
    const std::size_t a = line[k];
    const std::size_t b = line[k + 1];
    if (!exists(k)) {
      finish();
    } else if (grid.mesh.point[a] != grid.mesh.point[b]) {
      if (chain.empty()) chain.push_back(static_cast<std::uint32_t>(a));
      chain.push_back(static_cast<std::uint32_t>(b));
    }
  }
  finish();
}

}  // namespace

std::vector<std::vector<std::uint32_t>> grid_lines(const Grid& grid,
                                                   const std::vector<std::size_t>& columns,
                                                   const std::vector<std::size_t>& rows) {
  const auto has_triangles = [&](std::size_t i, std::size_t j) {
    return i < grid.cells_u && j < grid.cells_v && grid.triangle_count(grid.cell(i, j)) > 0;
  };
  std::vector<Chain> chains;
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
  return chains;
}

}  // namespace saddle
