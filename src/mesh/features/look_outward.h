// Looks outward of the gaps that bisection leaves, and tells jumps from values of their own, poles
// and steep slopes.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/features/bisected_vector.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// A gap between neighbouring doubles on a line.
struct LeftGap {
  Line line;
  Line ends;  ///< of the gap, in the direction of the line
  std::array<dvec3, 2> at_ends;
  bool is_between;  ///< between the ends there is no value, or one of its own
};

/// The kind of a gap, and where its sheets end.
struct OutwardLook {
  Discontinuity kind;
  Line ends;
};

/// Moves ends of jumps outward. At a jump a formula may have a value of its own, as sign(0) is 0,
/// for some doubles: it belongs to neither side. An end moves to the last place outward whose value
/// is far from the one before, within its line. If that is the outermost place, the surface is
/// steep, and the last moves, each larger than the one before, do not count. Where the end moves
/// all the way it may go to infinity.
std::vector<OutwardLook> look_outward(const Surface& surface, std::span<const LeftGap> gaps,
                                      const BisectedVector& bisected, unsigned threads);

}  // namespace saddle
