// Bisects the gap between a vector's values at the ends of a line of parameters, until the gap
// closes or there are no doubles left between the ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/features/bisected_vector.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// A discontinuity on a line, between neighbours in double precision.
struct LocatedDiscontinuity {
  Discontinuity kind = Discontinuity::None;
  Line ends{dvec2(0), dvec2(0)};      ///< in the direction of the line
  std::optional<dvec2> between = {};  ///< the line has others: a place before the next one
  /// All jumps of the line in its order, if no others are found where bounds do not exclude them.
  std::vector<Line> jumps = {};
  bool is_proved = false;      ///< bounds exclude others of more than the tolerance
  bool has_waves = false;      ///< more than kMostLineParts jumps were found
  bool is_cusp = false;        ///< the normal turns to its opposite; the tangents do not jump
  bool has_passed_by = false;  ///< a larger gap than that of a first part was not followed
};

/// A line, and the values at its ends of the vector that may jump on it.
struct Bracket {
  Line line;
  Line whole;  ///< the line that it is a part of
  std::array<dvec3, 2> at_ends;
  /// Derivatives of positions at the ends, by the share of the line.
  std::array<dvec3, 2> slopes = {dvec3(0), dvec3(0)};
};

/// A line on which positions may jump, from the surface at its ends.
Bracket bracket_of(const Line& line, const Line& whole, const SurfacePoint& first,
                   const SurfacePoint& last);

/// Goes on with the larger part of each gap until both parts are below `delta`, or there are no
/// doubles left: then the vector jumps, or has a pole if the gap has grown on the way. A line with
/// an undefined end has no discontinuity. Adds to `work` the number of points evaluated.
std::vector<LocatedDiscontinuity> bisect_discontinuities(const Surface& surface,
                                                         std::span<const Bracket> gaps,
                                                         const BisectedVector& bisected,
                                                         unsigned threads, std::size_t& work);

/// Which of several jumps of a line is found.
enum class Prefer : std::uint8_t { Largest, First };

/// How positions are bisected: see BisectedVector.
struct BisectedPositions {
  double delta;
  Prefer prefer = Prefer::Largest;
  int halvings = kAllHalvings;
};

/// The same for positions. Adds to `work` the number of points evaluated.
std::vector<LocatedDiscontinuity> bisect_positions(const Surface& surface,
                                                   std::span<const Bracket> gaps,
                                                   const BisectedPositions& bisected,
                                                   unsigned threads, std::size_t& work);

/// The place at which lines are halved: a little off the middle, where formulas often have cusps
/// and no normal.
dvec2 near_middle(const Line& line);

}  // namespace saddle
