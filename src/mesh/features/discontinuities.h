// Tells jumps and poles from steep slopes, and creases from bends, along straight lines in the (u,
// v) plane.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/features/bisect_discontinuities.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Follows the larger part of the gap between the positions at the ends of each line until both
/// parts are below `delta`, which shows that the surface is continuous there, or the parameters
/// have run out of digits: then it jumps, or goes to infinity if the gap has grown on the way.
/// Nothing is found on a line with an end where the surface is not defined. What samples do not
/// show because they are alike is looked for where bounds do not prove that the surface is
/// continuous. Adds to `work` the points and boxes that were looked at.
std::vector<LocatedDiscontinuity> find_discontinuities(const Surface& surface,
                                                       std::span<const Line> lines, double delta,
                                                       unsigned threads, std::size_t& work);

/// As find_discontinuities(), of unit normals: where they jump by more than kCreaseDegrees the
/// surface has a crease, or, if to their opposites, a cusp. `normals`: along r_u x r_v, at the ends
/// of each line.
std::vector<LocatedDiscontinuity> find_creases(const Surface& surface, std::span<const Line> lines,
                                               std::span<const std::array<dvec3, 2>> normals,
                                               unsigned threads, std::size_t& work);

}  // namespace saddle
