// The envelope of a surface that oscillates too fast for its mesh: vertices move to its extremes.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "mesh/grid/grid.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Moves the vertices between oscillating leaves to minima and maxima of the surface nearby, on
/// alternate lines, so that the mesh fills the band that the waves sweep. Vertices stay on the
/// surface; in (u, v) each one stays nearest to its own place.
/// Source: S. Steinarsson, "Downsampling time series for visual representation", 2013, on minima
/// and maxima of intervals.
void reach_extremes(const Surface& surface, std::span<const Leaf> leaves,
                    const std::function<bool(const Leaf&)>& oscillates, unsigned threads,
                    const CellTree& tree, Grid& grid);

}  // namespace saddle
