// How far the mesh of a grid is from its surface, measured at random points of some cells. These
// are samples of the error: nothing is known of what is between them.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/grid/grid.h"

namespace saddle {

struct MeasuredError {
  double distance = 0;        ///< largest, from a point of the surface to the triangles of its cell
  double normal_degrees = 0;  ///< largest angle of exact and interpolated normal at such a point
  std::size_t evaluations = 0;
};

/// Evaluates the surface inside and on two edges of cells: of all cells if they are few, else of
/// those whose triangles look worst and of as many spread over the domain. The points are off the
/// cells' middles by up to a tenth of a cell, at random: a surface that oscillates in step with the
/// grid is found out. `opened`: the cells that were not plain.
MeasuredError measure_error(const Surface& surface, const Grid& grid,
                            std::span<const std::size_t> opened, unsigned threads);

}  // namespace saddle
