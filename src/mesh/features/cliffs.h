// Cliffs: parts of lines of parameters in which a continuous surface rises along a straight
// segment, as clamp(1e4*u, 0, 1) and tanh(1e4*u) do. However short the part, two vertices show it
// exactly.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// The cliff on each line, from the first to the last of its places; nothing on a line that slopes
/// at its ends explain to `delta`, or whose steep part is not straight to a part of that. A cliff
/// rises by more than `delta` within three quarters of its line. Adds to `work` the number of
/// points evaluated.
std::vector<std::optional<Line>> find_cliffs(const Surface& surface, std::span<const Line> lines,
                                             double delta, unsigned threads, std::size_t& work);

}  // namespace saddle
