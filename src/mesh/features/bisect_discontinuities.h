// Follows a gap between the ends of a line in the (u, v) plane until it closes or the parameters
// have run out of digits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

enum class Discontinuity : std::uint8_t { None, Jump, Pole };

/// What is found on a line, and between which neighbours in double precision.
struct LocatedDiscontinuity {
  Discontinuity kind = Discontinuity::None;
  Line ends{dvec2(0), dvec2(0)};  ///< the first is the one nearer to the line's first end
  bool has_more = false;          ///< there are others on the line
  bool is_cusp = false;           ///< the normal goes to its opposite: the tangents do not jump
};

/// A line, and the vector that may jump on it, at its ends.
struct Bracket {
  Line line;
  std::array<dvec3, 2> at_ends;
};

/// Which vector is followed, and how.
struct BisectedVector {
  std::function<dvec3(const SurfacePoint&)> value;  ///< not finite where there is none
  /// What changes its sign where the vector jumps, of its values at the ends of what is left of a
  /// line and of a point there; smooth. Without it lines are halved.
  std::function<double(const std::array<dvec3, 2>&, const SurfacePoint&)> height;
  double delta;        ///< a gap that is smaller is none
  double beyond;       ///< ends of breaks go on outward to what is this far from them
  bool are_positions;  ///< the vectors are the surface's points
  int plain;           ///< halvings before heights are asked for
};

/// Follows the larger part of each gap until both are below `delta`, or the parameters have run out
/// of digits: then the vector jumps, or goes to infinity if the gap has grown on the way. Nothing
/// is found on a line with an end where there is no value. Adds to `work` the points looked at.
std::vector<LocatedDiscontinuity> bisect_discontinuities(const Surface& surface,
                                                         std::span<const Bracket> gaps,
                                                         const BisectedVector& bisected,
                                                         unsigned threads, std::size_t& work);

/// Where lines are halved: a little off their middles, which are the places where a formula for
/// half of a range has its cusps, and no normal.
dvec2 near_middle(const Line& line);

}  // namespace saddle
