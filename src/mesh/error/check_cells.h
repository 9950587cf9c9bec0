// Measures the errors of all cells of a grid at points between its vertices. The points of a row or
// column of cells are in step, so that what depends on u or v alone is computed once for them.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/error/measure_grid.h"

namespace saddle {

/// Which columns and rows of a grid are visible lines. The distance of such a line from its chords
/// counts in any direction.
struct SeenLines {
  std::vector<std::uint8_t> columns, rows;  ///< not 0: visible
};

/// Evaluates the surface at four places inside each cell, near its centre and near the middles of
/// its sides. All cells of the grid must be cut. Where the surface is undefined or has no regular
/// normal, the distance is infinite and the angle 180 degrees.
MeasuredError check_cells(const Surface& surface, const Grid& grid, const SeenLines& seen,
                          unsigned threads);

}  // namespace saddle
