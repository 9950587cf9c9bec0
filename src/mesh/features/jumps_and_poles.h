// Bisects positions on lines and parts of lines, and tells jumps from poles.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/features/bisect_discontinuities.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

double length_of(const Line& line);

/// The discontinuities of lines by their ends, with the `delta` of bisect_discontinuities(). A gap
/// also grows at a jump if the ends of its line happen to be alike, and beside a pole rounding
/// makes jumps: the surface diverges beside poles alone.
std::vector<LocatedDiscontinuity> follow_lines(const Surface& surface, std::span<const Line> lines,
                                               double delta, unsigned threads, std::size_t& work);

/// The discontinuities in unproved parts of lines. Around a pole of even order both ends of a part
/// may be alike: it is one if the surface diverges on either way to the part.
std::vector<LocatedDiscontinuity> look_at(const Surface& surface, std::span<const Line> lines,
                                          std::span<const LinePart> unproved_parts, double delta,
                                          unsigned threads, std::size_t& work);

}  // namespace saddle
