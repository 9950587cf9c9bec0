// Finds creases and cusps along straight lines of parameters, and tells them from bends.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/features/bisect_discontinuities.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Searches lines for jumps of unit normals, as find_discontinuities() does positions. A jump by
/// more than kCreaseDegrees is a crease, or a cusp if the normal turns to its opposite. `normals`:
/// along r_u x r_v, at the ends of each line. `patience`: with proofs that there is none.
std::vector<LocatedDiscontinuity> find_creases(const Surface& surface, std::span<const Line> lines,
                                               std::span<const std::array<dvec3, 2>> normals,
                                               unsigned threads, Patience& patience,
                                               std::size_t& work);

}  // namespace saddle
