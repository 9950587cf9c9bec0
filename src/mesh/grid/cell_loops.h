// The loop that cuts the cells between two rows of vertices, compiled once for each CPU level.
#pragma once

#include <array>
#include <cstddef>

#include "eval/kernels.h"

namespace saddle {

/// Cells per side of a tile. Two rows of positions and normals (25 KB) and the tape's slots stay in
/// the first or second-level cache; tiles compute 1 in 128 vertices twice.
inline constexpr std::size_t kTileCells = 256;

using TileNumbers = std::array<double, kTileCells + 1>;

/// Positions and unit normals of one row of a tile.
struct Strip {
  TileNumbers x, y, z;
  TileNumbers n_x, n_y, n_z;
  double size = 0;  ///< largest |x|, |y| or |z|
};

/// The cuts of cells, and whether they are plain.
struct Cuts {
  TileNumbers second;   ///< 0: best cut from slot 0 to 2; 1: from slot 1 to 3
  TileNumbers margin;   ///< positive: a plain cell
  TileNumbers sagitta;  ///< the largest of the diagonal and two sides
};

/// Cuts the cells between two strips. `front`: 1, or -1 where slots 0 to 3 run clockwise seen from
/// the front.
using CutCells = void (*)(const Strip& lower, const Strip& upper, std::size_t cells, double front,
                          Cuts& cuts);

/// The loop of a level; all give the same bits.
CutCells cell_loop(CpuLevel level);

}  // namespace saddle
