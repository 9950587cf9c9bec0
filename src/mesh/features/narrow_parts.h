// Narrows parts of lines without a proof of continuity down to poles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Narrows parts that are as short as kSame of their line, as poles show only at the last doubles:
/// to 1/2048 around their steepest place if bounds prove the rest continuous, else by unproved().
/// Parts stay if they are bounded and have a step above `delta` between their ends; those that are
/// proved are dropped. Returns all parts in the order of lines. Adds to `work` the number of points
/// and boxes. `enclosure`: of positions.
std::vector<LinePart> narrowed(const Surface& surface, SurfaceEnclosure& enclosure,
                               std::span<const Line> lines, std::span<const LinePart> parts,
                               double delta, std::size_t& work);

}  // namespace saddle
