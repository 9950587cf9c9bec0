// How far the mesh of a grid is from its surface, measured at random points of some cells. These
// are samples of the error: it may be larger between them.
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

/// Evaluates the surface inside and on two edges of at most 2,048 cells: all of a small grid; else
/// the half with the largest sagittas, and as many spread over the domain. Points are randomly off
/// the middles by up to a tenth of a cell, so that oscillations in step with the grid are found.
/// `opened`: the cells that were not plain.
MeasuredError measure_error(const Surface& surface, const Grid& grid,
                            std::span<const std::size_t> opened, unsigned threads);

}  // namespace saddle
