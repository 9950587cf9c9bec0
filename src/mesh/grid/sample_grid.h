// A tensor grid sampled, and its plain cells triangulated.
#pragma once

#include <optional>
#include <vector>

#include "mesh/grid/grid.h"

namespace saddle {

/// Evaluates the surface on the grid of lines u x v (at least two each, the ends those of the
/// domain) and cuts the plain cells. The extent is that of the part in `clip`. Throws Error: Input
/// for a grid with too many corners for their numbers; Nothing as set_extent(), unless no cell has
/// four defined corners.
Grid sample_grid(const Surface& surface, std::vector<double> u, std::vector<double> v,
                 unsigned threads, const std::optional<Bounds>& clip = {});

}  // namespace saddle
