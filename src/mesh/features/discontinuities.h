// Finds jumps and poles along straight lines of parameters, and tells them from steep slopes: by
// bisection where samples show a gap, and by interval proofs elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/features/bisect_discontinuities.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Bisects the gap between the positions at the ends of each line, as bisect_discontinuities()
/// does, with the same `delta`. A line with an undefined end has no discontinuity. Where the ends
/// are alike, it searches the parts of the line that bounds do not prove to be continuous. Adds to
/// `work` the number of points and boxes.
std::vector<LocatedDiscontinuity> find_discontinuities(const Surface& surface,
                                                       std::span<const Line> lines, double delta,
                                                       unsigned threads, std::size_t& work);

/// All jumps of lines on which find_discontinuities() found more than one, in the order of the
/// line. None for a line that leads to a pole or has more than kMostLineParts.
std::vector<std::vector<Line>> find_all_jumps(const Surface& surface, std::span<const Line> lines,
                                              std::span<const LocatedDiscontinuity> found,
                                              double delta, unsigned threads, std::size_t& work);

}  // namespace saddle
