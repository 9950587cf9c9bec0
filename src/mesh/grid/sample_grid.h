// A tensor grid sampled, and its plain cells triangulated.
#pragma once

#include <optional>
#include <vector>

#include "mesh/grid/grid.h"

namespace saddle {

/// Evaluates the surface on the grid of lines u x v (at least two each, the ends those of the
/// domain) and cuts the cells that are plain. Throws Error: Input for a grid whose corners could
/// not be numbered; Nothing as set_extent() does, which is not called where no cell has four
/// defined corners. The extent is that of what is in `clip`.
Grid sample_grid(const Surface& surface, std::vector<double> u, std::vector<double> v,
                 unsigned threads, const std::optional<Bounds>& clip = {});

}  // namespace saddle
