// Vertices where the surface oscillates too fast for its mesh to follow.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "mesh/grid/grid.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Moves the vertices that have nothing but such leaves around them to where the surface is at its
/// extremes nearby, alternately to either side: what waves sweep is filled as far as they reach, as
/// a trace on an oscilloscope is, in place of chords between places that samples happened to meet.
/// They stay on the surface, nearer to their own places in (u, v) than to those of others.
/// Source: S. Steinarsson, "Downsampling time series for visual representation", 2013, on minima
/// and maxima of intervals.
void reach_extremes(const Surface& surface, std::span<const Leaf> leaves,
                    const std::function<bool(const Leaf&)>& oscillates, unsigned threads,
                    const CellTree& tree, Grid& grid);

}  // namespace saddle
