#include "mesh/tile.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "mesh/triangulate.h"

namespace saddle {

namespace {

constexpr std::size_t kVertices = kTileCells + 1;
using Numbers = std::array<double, kVertices>;

/// Positions and unit normals of one row of a tile.
struct Strip {
  std::array<Numbers, 6> of;  ///< x y z, then those of the normal
  double size = 0;            ///< largest |x|, |y| or |z|
};

/// Lanes of the loops that look for extremes, so that the compiler can use vectors: it may not
/// change the order of comparisons by itself.
constexpr std::size_t kLanes = 8;

/// fold(x[0], x[1], ...) for a fold that does not mind the order.
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
  // 0 times infinity and NaN are NaN, which no sum gets rid of.
  return reduce(numbers, count, [](double a, double b) { return a * 0.0 + b * 0.0; }) * 0.0 == 0;
}

/// A row's outputs: x y z, the unit normal, |r_u x r_v|, |r_u|^2, |r_v|^2.
RowSummary summarize(std::span<const Operand> outputs, std::size_t count) {
  RowSummary summary;
  summary.finite = std::all_of(outputs.begin(), outputs.end(),
                               [&](const Operand& o) { return all_finite(o, count); });
  summary.least_cross = smallest(outputs[6], count);
  summary.largest_uu = largest(outputs[7], count);
  summary.largest_vv = largest(outputs[8], count);
  return summary;
}

void load(std::span<const Operand> outputs, std::size_t count, bool flipped, Strip& strip,
          Bounds& bounds) {
  for (std::size_t k = 0; k < strip.of.size(); ++k) {
    if (outputs[k].varies) {
      std::copy_n(outputs[k].data, count, strip.of[k].begin());
    } else {
      std::fill_n(strip.of[k].begin(), count, *outputs[k].data);
    }
  }
  if (flipped) {
    for (std::size_t k = 3; k < 6; ++k) {
      std::transform(strip.of[k].begin(), strip.of[k].begin() + count, strip.of[k].begin(),
                     std::negate());
    }
  }
  strip.size = 0;
  for (int k = 0; k < 3; ++k) {
    const double low = smallest(outputs[static_cast<std::size_t>(k)], count);
    const double high = largest(outputs[static_cast<std::size_t>(k)], count);
    strip.size = std::max({strip.size, std::fabs(low), std::fabs(high)});
    bounds.low[k] = std::min(bounds.low[k], low);
    bounds.high[k] = std::max(bounds.high[k], high);
  }
}

/// Writes the vertices of a row that belong to the tile: those on its far sides are the
/// neighbours', unless there is none.
void store(const Strip& strip, const GridTile& tile, std::size_t row, Grid& grid) {
  if (row == tile.row + tile.rows - 1 && row < grid.cells_v) return;
  const bool last = tile.column + tile.columns == grid.u.size();
  const std::size_t count = last ? tile.columns : tile.columns - 1;
  const std::size_t first = grid.vertex(tile.column, row);
  dvec3* const position = grid.mesh.position.data() + first;
  dvec3* const normal = grid.mesh.normal.data() + first;
  const auto& [x, y, z, n_x, n_y, n_z] = strip.of;
  for (std::size_t i = 0; i < count; ++i) {
    position[i] = {x[i], y[i], z[i]};
    normal[i] = {n_x[i], n_y[i], n_z[i]};
  }
  for (std::size_t i = 0; i < count; ++i) {
    grid.mesh.uv[first + i] = {grid.u[tile.column + i], grid.v[row]};
    grid.mesh.point[first + i] = static_cast<std::uint32_t>(first + i);
  }
}

/// The best cut of each cell of a row, and how far it is from being one that is not plain.
struct Cuts {
  Numbers diagonal;  ///< 0: from slot 0 to 2; 1: from slot 1 to 3
  Numbers margin;    ///< positive: a plain cell
  Numbers sagitta;   ///< the largest of the diagonal and two sides
};

/// A cell is plain if both triangles of its best cut face as its normals do, by more than the
/// rounding of positions could pretend: twice the area along the sum of the four normals, at most
/// 4 long, must exceed this times the largest coordinate and the root of the sum of squares of four
/// edges, of which no other edge is longer than twice. That is 2 * 2 * 2 * 4 * sqrt(3) roundings,
/// and needles thinner than a rounding fail it too.
constexpr double kPlain = 64 * kRounding;

/// All cells between two rows. The choice is that of triangulate.cpp, for cells with four regular
/// normals; plain loops over plain numbers, which the compiler makes vectors of.
void cut_cells(const Strip& lower, const Strip& upper, std::size_t cells, double front,
               Cuts& cuts) {
  const auto& [ax, ay, az, anx, any, anz] = lower.of;
  const auto& [bx, by, bz, bnx, bny, bnz] = upper.of;
  const double size = std::max(lower.size, upper.size);
  const double least = kPlain * kPlain * size * size;
  for (std::size_t i = 0; i < cells; ++i) {
    const double d1x = bx[i + 1] - ax[i];
    const double d1y = by[i + 1] - ay[i];
    const double d1z = bz[i + 1] - az[i];
    const double d2x = bx[i] - ax[i + 1];
    const double d2y = by[i] - ay[i + 1];
    const double d2z = bz[i] - az[i + 1];
    const double s1 = std::fabs((bnx[i + 1] - anx[i]) * d1x + (bny[i + 1] - any[i]) * d1y +
                                (bnz[i + 1] - anz[i]) * d1z);
    const double s2 = std::fabs((bnx[i] - anx[i + 1]) * d2x + (bny[i] - any[i + 1]) * d2y +
                                (bnz[i] - anz[i + 1]) * d2z);
    const double l1 = d1x * d1x + d1y * d1y + d1z * d1z;
    const double l2 = d2x * d2x + d2y * d2y + d2z * d2z;
    const double by_sagitta = is_smaller(s2, s1) ? 1.0 : 0.0;
    const double by_length = is_smaller(s1, s2) ? 0.0 : is_smaller(l2, l1) ? 1.0 : 0.0;
    const double second = std::max(by_sagitta, by_length);

    // Twice the cell's vector area is d1 x d2; that of the triangle at slot 0 or 1, e x w.
    const double ex = ax[i + 1] - ax[i];
    const double ey = ay[i + 1] - ay[i];
    const double ez = az[i + 1] - az[i];
    const double gx = bx[i] - ax[i];
    const double gy = by[i] - ay[i];
    const double gz = bz[i] - az[i];
    const double wx = second > 0 ? gx : d1x;
    const double wy = second > 0 ? gy : d1y;
    const double wz = second > 0 ? gz : d1z;
    const double nx = anx[i] + anx[i + 1] + bnx[i] + bnx[i + 1];
    const double ny = any[i] + any[i + 1] + bny[i] + bny[i + 1];
    const double nz = anz[i] + anz[i + 1] + bnz[i] + bnz[i + 1];
    const double whole = front * ((d1y * d2z - d1z * d2y) * nx + (d1z * d2x - d1x * d2z) * ny +
                                  (d1x * d2y - d1y * d2x) * nz);
    const double part =
        front * ((ey * wz - ez * wy) * nx + (ez * wx - ex * wz) * ny + (ex * wy - ey * wx) * nz);
    const double rest = whole - part;
    const double area = rest < part ? rest : part;  // the smaller one
    const double edges = l1 + l2 + ex * ex + ey * ey + ez * ez + gx * gx + gy * gy + gz * gz;
    const double margin = area * area - least * edges;
    cuts.diagonal[i] = second;
    cuts.margin[i] = area > 0 ? margin : -1.0;
    const double se = std::fabs((anx[i + 1] - anx[i]) * ex + (any[i + 1] - any[i]) * ey +
                                (anz[i + 1] - anz[i]) * ez);
    const double sg =
        std::fabs((bnx[i] - anx[i]) * gx + (bny[i] - any[i]) * gy + (bnz[i] - anz[i]) * gz);
    const double sd = second > 0 ? s2 : s1;
    const double side = sg > se ? sg : se;
    cuts.sagitta[i] = 0.125 * (side > sd ? side : sd);  // see sagitta()
  }
}

/// Cells of which the worst is remembered.
constexpr std::size_t kGroup = 16;

/// Writes the triangles of a row of cells, `row` being the one above it.
void write_cells(const Cuts& cuts, const GridTile& tile, std::size_t row, Grid& grid,
                 TileSummary& summary) {
  const std::size_t first = grid.cell(tile.column, row - 1);
  const auto pitch = static_cast<std::uint32_t>(grid.u.size());
  auto vertex = static_cast<std::uint32_t>(grid.vertex(tile.column, row - 1));
  const std::size_t turn = grid.mirrored ? 1 : 0;
  CellError worst{first, -1};
  for (std::size_t i = 0; i + 1 < tile.columns; ++i, ++vertex) {
    if (i % kGroup == 0 && worst.sagitta >= 0) {
      summary.worst.push_back(worst);
      worst.sagitta = -1;
    }
    const bool plain = cuts.margin[i] > 0;
    grid.cells[first + i] = plain ? Cell::Two : Cell::Open;
    if (!plain) {
      summary.any_open = true;
      continue;
    }
    const std::uint32_t across = vertex + pitch;
    const bool second = cuts.diagonal[i] > 0;
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
  for (std::size_t k = 0; rows.next(); ++k) {
    Strip& strip = (*strips)[k % 2];
    summary.rows.push_back(summarize(rows.outputs(), tile.columns));
    load(rows.outputs(), tile.columns, grid.flipped, strip, summary.bounds);
    store(strip, tile, rows.row(), grid);
    if (k == 0) continue;
    const Strip& below = (*strips)[(k - 1) % 2];
    cut_cells(below, strip, tile.columns - 1, grid.mirrored ? -1 : 1, *cuts);
    write_cells(*cuts, tile, rows.row(), grid, summary);
  }
  return summary;
}

}  // namespace saddle
