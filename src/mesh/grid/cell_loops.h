// Loops over the cells between two rows of vertices, compiled for each CPU level: one cuts them,
// one tells how far off they are.
#pragma once

#include <array>
#include <cstddef>

#include "eval/kernels.h"

namespace saddle {

/// Cells per side of a tile: two rows of positions and normals (25 KB) and the tape's slots stay in
/// a first or second-level cache, and the vertices that neighbours compute twice are 1 in 128.
inline constexpr std::size_t kTileCells = 256;

using TileNumbers = std::array<double, kTileCells + 1>;

/// Positions and unit normals of one row of a tile.
struct Strip {
  TileNumbers x, y, z;
  TileNumbers n_x, n_y, n_z;
  double size = 0;  ///< largest |x|, |y| or |z|
};

/// What the loop finds out about each cell.
struct Cuts {
  TileNumbers second;   ///< 0: best cut from slot 0 to 2; 1: from slot 1 to 3
  TileNumbers margin;   ///< positive: a plain cell
  TileNumbers sagitta;  ///< the largest of the diagonal and two sides
};

/// Cuts the cells between two strips. `front`: 1, or -1 where slots 0 to 3 run clockwise seen from
/// the front.
using CutCells = void (*)(const Strip& lower, const Strip& upper, std::size_t cells, double front,
                          Cuts& cuts);

/// One place of the surface in each cell, all as far along v, or on the cells' border.
struct RowPlaces {
  const double* along_u;  ///< where it is in its cell: 0 to 1
  double along_v;
  /// How its cell is cut: as Cuts::second tells, or less than 0 where that is not known.
  const double* second;
  std::array<const double*, 9> surface;  ///< NormalColumns
  double scale;                          ///< local units, those of the strips, per unit of length
  double front;                          ///< 1: vertices' normals are along r_u x r_v; or -1
};

struct RowErrors {
  TileNumbers distance;  ///< of the triangle from the surface, straight below it, in local units
  TileNumbers chord;     ///< between unit normals, exact and interpolated: its square
  TileNumbers is_known;  ///< 1; 0: a closer look is to be taken
};

/// Checks the places in the cells [0, count) between two strips.
using CheckRow = void (*)(const Strip& lower, const Strip& upper, const RowPlaces& places,
                          std::size_t count, RowErrors& sampled_errors);

/// The loops of a level; all give the same bits.
CutCells cell_loop(CpuLevel level);
CheckRow check_loop(CpuLevel level);

}  // namespace saddle
