// Narrows parts of lines without a proof of continuity down to poles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Narrows parts of lines that are as short as kSame down to a few doubles, unless there is a step
/// above `delta` between their ends and they are bounded: poles show only at the last doubles.
/// Returns these and the other parts, in the order of lines. Adds to `work` the number of points
/// and boxes.
std::vector<LinePart> narrowed(const Surface& surface, std::span<const Line> lines,
                               std::span<const LinePart> parts, double delta, unsigned threads,
                               std::size_t& work);

}  // namespace saddle
