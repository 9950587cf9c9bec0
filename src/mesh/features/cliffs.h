// Cliffs: parts of lines of parameters in which a continuous surface rises steeply along a straight
// segment, as clamp(1e4*u, 0, 1) and tanh(1e4*u) do, or along a few segments, as around an edge
// that is made with differences. However short the part, their ends show it.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// The part of the way from an end of a cliff to the place on it to which the end is found.
inline constexpr double kNearEnd = 1.0 / 32;

/// Parameters on a line, from foot to head; the surface rises along the segments between
/// neighbours.
using Cliff = std::vector<dvec2>;

/// The cliff on each line; an empty one on a line that slopes at its ends explain to `delta`, or
/// whose steep part is not near to at most 32 segments to a part of that. A cliff rises by more
/// than `delta` within three quarters of its line. Adds to `work` the number of points evaluated.
std::vector<Cliff> find_cliffs(const Surface& surface, std::span<const Line> lines, double delta,
                               unsigned threads, std::size_t& work);

}  // namespace saddle
