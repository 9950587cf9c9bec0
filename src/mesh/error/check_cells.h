// All cells of a grid measured on points that nobody has looked at before, of which those of a row
// or column of cells are in step: what depends on u alone or v alone is computed once for them.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/error/measure_grid.h"

namespace saddle {

/// Which columns and rows of a grid are seen as lines: their chords must follow them, wherever the
/// surface is.
struct SeenLines {
  std::vector<std::uint8_t> columns, rows;  ///< one for each of the grid's
};

/// Evaluates the surface at four places inside each cell, near its centre and near the middles of
/// its sides. Of a grid all of whose cells are cut. Where the surface is undefined or has no
/// regular normal at such a place, it is infinitely far off and turned by 180 degrees.
MeasuredError check_cells(const Surface& surface, const Grid& grid, const SeenLines& seen,
                          unsigned threads);

}  // namespace saddle
