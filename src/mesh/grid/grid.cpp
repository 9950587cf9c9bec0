#include "mesh/grid/grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "mesh/grid/irregular.h"
#include "mesh/grid/tile.h"
#include "surface/normal.h"

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

/// The mesh's arrays at their sizes, with room for some more corners at singular vertices: memory
/// that is not touched costs nothing, moving a million vertices does.
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

std::string format_point(const dvec3& p) {
  const auto number = [](double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", x);
    return std::string(text.data());
  };
  return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
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

/// What both boxes hold; all of the first if that is nothing.
Bounds common(const Bounds& bounds, const std::optional<Bounds>& clip) {
  if (!clip) return bounds;
  const Bounds both{glm::max(bounds.low, clip->low), glm::min(bounds.high, clip->high)};
  return glm::all(glm::lessThanEqual(both.low, both.high)) ? both : bounds;
}

}  // namespace

void set_extent(Grid& grid, const Bounds& bounds) {
  grid.mesh.bounds = bounds;
  const double diagonal = safe_length(bounds.size());
  if (!std::isfinite(diagonal)) {
    throw Error(Status::Nothing, "the surface has no finite extent", {},
                "its finite samples reach from " + format_point(bounds.low) + " to " +
                    format_point(bounds.high));
  }
  const dvec3 least = rounding_of(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
  const bool is_point = glm::all(glm::lessThanEqual(bounds.size(), least));
  if (is_point || diagonal < std::numeric_limits<double>::min()) {
    throw Error(Status::Nothing, "the surface is a single point, " + format_point(bounds.low), {},
                "x, y and z are the same at all samples");
  }
  grid.local_scale = std::ldexp(1.0, -std::ilogb(diagonal));
  grid.diagonal = grid.local_scale * diagonal;
}

std::vector<double> even_lines(double first, double last, std::size_t cells) {
  std::vector<double> values(cells + 1);
  const auto n = static_cast<double>(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    // Weighting the ends, rather than stepping from the first, makes symmetric ranges symmetric to
    // the last bit and hits 0 where it is a line.
    const auto k = static_cast<double>(i);
    const double value = (first * (n - k) + last * k) / n;
    values[i] = std::isfinite(value) ? value : std::lerp(first, last, k / n);
  }
  values.front() = first;
  values.back() = last;
  return values;
}

dvec2 Grid::cell_centre(std::size_t cell) const {
  const std::size_t i = cell % cells_u;
  const std::size_t j = cell / cells_u;
  return {0.5 * u[i] + 0.5 * u[i + 1], 0.5 * v[j] + 0.5 * v[j + 1]};
}

std::array<std::size_t, 4> Grid::vertices(std::size_t cell) const {
  const std::size_t first = cell + cell / cells_u;  // a row has one vertex more than cells
  const std::size_t above = first + cells_u + 1;
  return {first, first + 1, above + 1, above};
}

bool Grid::is_used(std::size_t vertex) const {
  if (left_out_count == 0) return true;
  bool used = false;
  for_cells_around(vertex, [&used](std::size_t, std::size_t) { used = true; });
  return used;
}

void Grid::open_around(std::size_t vertex) {
  for_cells_around(vertex, [this](std::size_t cell, std::size_t) { cells[cell] = GridCell::Open; });
}

void require_defined_cells(const Grid& grid) {
  if (grid.left_out_count < grid.cell_count()) return;
  const auto& positions = grid.mesh.position;
  const auto samples = std::count_if(positions.begin(), positions.end(), is_finite);
  const std::string all = std::to_string(positions.size());
  if (samples == 0) {
    throw Error(Status::Nothing, "the surface is undefined everywhere", {},
                "none of the " + all + " samples has finite x, y and z");
  }
  throw Error(Status::Nothing, "the surface is defined at isolated samples only", {},
              std::to_string(samples) + " of " + all +
                  " samples are finite, but no four around a cell; --samples takes more");
}

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
  for (const TileSummary& tile : tiles) {
    grid.worst.insert(grid.worst.end(), tile.worst.begin(), tile.worst.end());
  }
  return grid;
}

}  // namespace saddle
