// Bisects the gap between a vector's values at the ends of a line of parameters, until the gap
// closes or there are no doubles left between the ends.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

enum class Discontinuity : std::uint8_t { None, Jump, Pole };

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

/// The vector that may jump, and how it is searched.
struct BisectedVector {
  std::function<dvec3(const SurfacePoint&)> value;  ///< not finite where it is undefined
  /// A smooth function that changes its sign where the vector jumps: of the values at the ends of
  /// the rest of a line, and of a point there. Without it lines are halved.
  std::function<double(const std::array<dvec3, 2>&, const SurfacePoint&)> height;
  double delta;        ///< a smaller gap is closed
  double beyond;       ///< a jump's end moves outward to values that differ from it by more
  bool are_positions;  ///< the vectors are positions
  int plain;           ///< halvings before heights are used
  /// Halvings of a line. A gap that is left before the last digits counts as a jump.
  int halvings = kAllHalvings;
  /// The first part of a line is followed if its gap is larger than this; else the larger part.
  double first_gap = std::numeric_limits<double>::infinity();
};

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
