#include "mesh/grid/sample_grid.h"

#include <span>
#include <string>
#include <utility>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/numbers.h"
#include "mesh/grid/irregular.h"
#include "mesh/grid/tile.h"

namespace saddle {
namespace {

/// Corners are numbered in 32 bits, and a vertex has at most four.
constexpr std::size_t kMaxCells = std::size_t{1} << 29;

void require_countable(std::size_t cells_u, std::size_t cells_v) {
  if (cells_u <= kMaxCells / cells_v) return;
  throw Error(Status::Input,
              "a grid of " + std::to_string(cells_u) + " x " + std::to_string(cells_v) +
                  " cells is too large",
              {}, "at most " + std::to_string(kMaxCells) + " cells");
}

/// Allocates the mesh's arrays, with room for more corners at singular vertices: untouched memory
/// costs nothing, moving a million vertices does.
void allocate(Grid& grid) {
  const std::size_t vertices = grid.vertex_count();
  const std::size_t room = vertices + vertices / 8;
  const auto make = [&](auto& array) {
    array.reserve(room);
    array.resize(vertices);
  };
  make(grid.mesh.position);
  make(grid.mesh.normal);
  make(grid.mesh.uv);
  make(grid.mesh.point);
  grid.mesh.triangles.resize(2 * grid.cell_count());
  grid.cells.resize(grid.cell_count());
}

Bounds bounds_of(const Grid& grid, std::span<const TileSummary> tiles) {
  Bounds bounds;
  for (const TileSummary& tile : tiles) bounds.add(tile.bounds);
  if (grid.left_out_count > 0) {
    bounds = Bounds();
    for (std::size_t vertex = 0; vertex < grid.vertex_count(); ++vertex) {
      if (grid.is_used(vertex)) bounds.add(grid.mesh.position[vertex]);
    }
  }
  return bounds;
}

/// The largest |r_u| and |r_v| of a grid's vertices.
dvec2 longest_tangents(std::span<const TileSummary> tiles) {
  dvec2 squares(0);
  for (const TileSummary& tile : tiles) {
    for (const RowSummary& row : tile.rows) {
      if (!row.finite) return dvec2(kInfinity);
      squares = glm::max(squares, dvec2(row.largest_uu, row.largest_vv));
    }
  }
  return glm::sqrt(squares);
}

/// The intersection of the boxes; the first box if it is empty.
Bounds common(const Bounds& bounds, const std::optional<Bounds>& clip) {
  if (!clip) return bounds;
  const Bounds both{glm::max(bounds.low, clip->low), glm::min(bounds.high, clip->high)};
  return glm::all(glm::lessThanEqual(both.low, both.high)) ? both : bounds;
}

}  // namespace

Grid sample_grid(const Surface& surface, std::vector<double> u, std::vector<double> v,
                 unsigned threads, const std::optional<Bounds>& clip) {
  Grid grid;
  grid.cells_u = u.size() - 1;
  grid.cells_v = v.size() - 1;
  require_countable(grid.cells_u, grid.cells_v);
  grid.u = std::move(u);
  grid.v = std::move(v);
  grid.range = glm::abs(dvec2(grid.u.back() - grid.u.front(), grid.v.back() - grid.v.front()));
  grid.flipped = surface.flip;
  grid.mirrored = runs_backwards(surface.domain) != surface.flip;
  allocate(grid);

  const GridTiling tiling(grid.cells_u, grid.cells_v, kTileCells);
  std::vector<TileSummary> tiles(tiling.count());
  evaluate_tiles(surface.normals, grid.u, grid.v, tiling, threads,
                 [&](TileRows& rows) { tiles[rows.tile().index] = take_tile(rows, grid); });
  find_irregular(surface, tiling, tiles, threads, grid);
  if (grid.left_out_count == grid.cell_count()) return grid;
  set_extent(grid, common(bounds_of(grid, tiles), clip));
  grid.longest_tangents = longest_tangents(tiles);
  for (const TileSummary& tile : tiles) {
    grid.worst.insert(grid.worst.end(), tile.worst.begin(), tile.worst.end());
  }
  return grid;
}

}  // namespace saddle
