#include "mesh/grid/tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "eval/vectors.h"

namespace saddle {

namespace {

/// Lanes of the loops for extremes: the compiler may not reorder comparisons by itself, and needs
/// them to use vectors.
constexpr std::size_t kLanes = 8;

/// fold(x[0], x[1], ...) in any order.
template <class Fold>
double reduce(const Operand& numbers, std::size_t count, Fold fold) {
  if (!numbers.varies) return *numbers.data;
  const double* const x = numbers.data;
  std::array<double, kLanes> lanes;
  lanes.fill(x[0]);
  std::size_t i = 0;
  for (; i + kLanes <= count; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) lanes[k] = fold(lanes[k], x[i + k]);
  }
  for (; i < count; ++i) lanes[0] = fold(lanes[0], x[i]);
  for (std::size_t k = 1; k < kLanes; ++k) lanes[0] = fold(lanes[0], lanes[k]);
  return lanes[0];
}

double smallest(const Operand& numbers, std::size_t count) {
  return reduce(numbers, count, [](double a, double b) { return b < a ? b : a; });
}
double largest(const Operand& numbers, std::size_t count) {
  return reduce(numbers, count, [](double a, double b) { return b > a ? b : a; });
}

bool all_finite(const Operand& numbers, std::size_t count) {
  // 0 times infinity or NaN is NaN, and so is every sum with it.
  return reduce(numbers, count, [](double a, double b) { return a * 0.0 + b * 0.0; }) * 0.0 == 0;
}

Operand column(const TileNumbers& numbers) {
  return {numbers.data(), true};
}

void load(const Operand& from, std::size_t count, TileNumbers& to) {
  if (from.varies) {
    std::copy_n(from.data, count, to.begin());
  } else {
    std::fill_n(to.begin(), count, *from.data);
  }
}

/// Loads a row's outputs, those of normal_outputs(), into the strip.
RowSummary load(std::span<const Operand> outputs, std::size_t count, bool flipped, Strip& strip,
                Bounds& bounds) {
  load(outputs[0], count, strip.x);
  load(outputs[1], count, strip.y);
  load(outputs[2], count, strip.z);
  TileNumbers area;
  const std::array units = {strip.n_x.data(), strip.n_y.data(), strip.n_z.data()};
  vector_loops(cpu_level())
      .normalize(&outputs[kNormalColumn], count, flipped ? -1 : 1, units.data(), area.data());
  strip.size = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = smallest(outputs[static_cast<std::size_t>(k)], count);
    const double high = largest(outputs[static_cast<std::size_t>(k)], count);
    strip.size = std::max({strip.size, std::fabs(low), std::fabs(high)});
    bounds.low[k] = std::min(bounds.low[k], low);
    bounds.high[k] = std::max(bounds.high[k], high);
  }
  RowSummary summary;
  const auto finite = [count](const Operand& numbers) { return all_finite(numbers, count); };
  summary.finite = std::ranges::all_of(outputs, finite) && finite(column(area)) &&
                   finite(column(strip.n_x)) && finite(column(strip.n_y)) &&
                   finite(column(strip.n_z));
  summary.least_cross = smallest(column(area), count);
  summary.largest_uu = largest(outputs[kSquareUColumn], count);
  summary.largest_vv = largest(outputs[kSquareVColumn], count);
  return summary;
}

/// Writes the vertices of a row that belong to the tile. Vertices on its far sides belong to the
/// next tiles, if there are any.
void store(const Strip& strip, const GridTile& tile, std::size_t row, Grid& grid) {
  if (row == tile.row + tile.rows - 1 && row < grid.cells_v) return;
  const bool last = tile.column + tile.columns == grid.u.size();
  const std::size_t count = last ? tile.columns : tile.columns - 1;
  const std::size_t first = grid.vertex(tile.column, row);
  const auto interleave = vector_loops(cpu_level()).interleave;
  const std::array positions = {column(strip.x), column(strip.y), column(strip.z)};
  const std::array normals = {column(strip.n_x), column(strip.n_y), column(strip.n_z)};
  interleave(positions.data(), count, &grid.mesh.position[first].x);
  interleave(normals.data(), count, &grid.mesh.normal[first].x);
  for (std::size_t i = 0; i < count; ++i) {
    grid.mesh.uv[first + i] = {grid.u[tile.column + i], grid.v[row]};
    grid.mesh.point[first + i] = static_cast<std::uint32_t>(first + i);
  }
}

/// The cell with the largest sagitta of each 16 is kept.
constexpr std::size_t kGroup = 16;

/// Writes the triangles of a row of cells, `row` being the one above it.
void write_cells(const Cuts& cuts, const GridTile& tile, std::size_t row, Grid& grid,
                 TileSummary& summary) {
  const std::size_t first = grid.cell(tile.column, row - 1);
  const auto pitch = static_cast<std::uint32_t>(grid.u.size());
  auto vertex = static_cast<std::uint32_t>(grid.vertex(tile.column, row - 1));
  const std::size_t turn = grid.mirrored ? 1 : 0;
  CellSagitta worst{first, -1};
  for (std::size_t i = 0; i + 1 < tile.columns; ++i, ++vertex) {
    if (i % kGroup == 0 && worst.sagitta >= 0) {
      summary.worst.push_back(worst);
      worst.sagitta = -1;
    }
    const bool plain = cuts.margin[i] > 0;
    grid.cells[first + i] = plain ? GridCell::Two : GridCell::Open;
    if (!plain) continue;
    const std::uint32_t across = vertex + pitch;
    const bool second = cuts.second[i] > 0;
    Triangle* const triangles = grid.mesh.triangles.data() + 2 * (first + i);
    // Slots 0 1 2 and 2 3 0, or 1 2 3 and 3 0 1.
    const Triangle a = second ? Triangle{vertex + 1, across + 1, across}
                              : Triangle{vertex, vertex + 1, across + 1};
    const Triangle b =
        second ? Triangle{across, vertex, vertex + 1} : Triangle{across + 1, across, vertex};
    triangles[0] = {a[0], a[1 + turn], a[2 - turn]};
    triangles[1] = {b[0], b[1 + turn], b[2 - turn]};
    if (cuts.sagitta[i] > worst.sagitta) worst = {first + i, cuts.sagitta[i]};
  }
  if (worst.sagitta >= 0) summary.worst.push_back(worst);
}

}  // namespace

TileSummary take_tile(TileRows& rows, Grid& grid) {
  const GridTile& tile = rows.tile();
  TileSummary summary;
  summary.rows.reserve(tile.rows);
  const auto strips = std::make_unique_for_overwrite<std::array<Strip, 2>>();
  const auto cuts = std::make_unique_for_overwrite<Cuts>();
  const CutCells cut_cells = cell_loop(cpu_level());
  for (std::size_t k = 0; rows.next(); ++k) {
    Strip& strip = (*strips)[k % 2];
    summary.rows.push_back(load(rows.outputs(), tile.columns, grid.flipped, strip, summary.bounds));
    store(strip, tile, rows.row(), grid);
    if (k == 0) continue;
    const Strip& below = (*strips)[(k - 1) % 2];
    cut_cells(below, strip, tile.columns - 1, grid.mirrored ? -1 : 1, *cuts);
    write_cells(*cuts, tile, rows.row(), grid, summary);
  }
  return summary;
}

}  // namespace saddle
