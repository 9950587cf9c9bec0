// The envelope of a surface that oscillates too fast for its mesh: vertices move to its extremes.
#pragma once

#include <cstddef>
#include <span>

#include "mesh/grid/grid.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Random places to try for each of `count` leaves or vertices in waves, which are 1 at least:
/// `least` to 16.
std::size_t tries_in_waves(std::size_t count, std::size_t least);

/// Whether corners of a leaf may move to extremes.
bool may_reach_extremes(const Leaf& leaf);

/// Moves the vertices between oscillating leaves to minima and maxima of the surface nearby, on
/// alternate lines, so that the mesh fills the band that the waves sweep. Vertices stay on the
/// surface; in (u, v) each one stays nearest to its own place.
/// Source: S. Steinarsson, "Downsampling time series for visual representation", 2013, on minima
/// and maxima of intervals.
void reach_extremes(const Surface& surface, std::span<const Leaf> leaves, unsigned threads,
                    const CellTree& tree, Grid& grid);

}  // namespace saddle
