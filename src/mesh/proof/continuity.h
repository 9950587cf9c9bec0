// Proves by interval bounds that a surface, or its normal, is continuous along lines of parameters.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"
#include "surface/surface_enclosure.h"

namespace saddle {

/// Open parts of a line beyond which bounds are too wide, and jumps beyond which there are waves.
inline constexpr std::size_t kMostLineParts = 8;

/// Halvings for a first proof of a line: more follow where it shows that bounds prove something.
inline constexpr int kFirstHalvings = 3;

/// A straight line of parameters.
using Line = std::array<dvec2, 2>;

/// The length of a line in parts of the ranges of u and v.
inline double length_in_ranges(const Line& line, const dvec2& ranges) {
  return glm::length((line[1] - line[0]) / ranges);
}

/// A line, or a part of one.
struct LinePart {
  std::size_t line;  ///< number of the line
  Line part;
  /// The end that lies beside a known discontinuity: there is no proof there.
  std::optional<std::size_t> broken_end = {};
};

/// Parts of lines on which the surface is proved neither to be continuous nor to stay within
/// `delta`: a jump there may be larger. A part is as short as doubles go, or one of a few that
/// stand for many, or left after `halvings`. Parts are in the order of lines and disjoint. Adds to
/// `boxes` the number of boxes tested. `enclosure`: of positions.
std::vector<LinePart> unproved(SurfaceEnclosure& enclosure, std::vector<LinePart> lines,
                               double delta, std::size_t& boxes, int halvings = kAllHalvings);

/// Lines on which there may be creases.
struct UnprovedNormals {
  std::vector<std::size_t> lines;  ///< numbers, in order
  /// Tangents are continuous in a box around all lines. A crease then lies where r_u x r_v goes
  /// through 0 and the normal turns to its opposite.
  bool only_cusps = false;
};

/// How many proofs of a call may fail, beyond one for each line proved: half as many after a call
/// that proves nothing, as no bounds prove anything of some surfaces.
class Patience {
 public:
  std::size_t failures() const { return failures_; }
  void learn(bool has_proved) { failures_ = has_proved ? kSearchedTogether : failures_ / 2; }

 private:
  std::size_t failures_ = kSearchedTogether;
};

/// The lines along which it is not proved that the tangents are continuous and r_u x r_v is not 0.
/// The others have no crease and no cusp. Proofs end where they fail repeatedly, or would cost more
/// than a search on the lines. Adds to `boxes` the number of boxes tested.
UnprovedNormals unproved_normals(const Surface& surface, std::span<const Line> lines,
                                 Patience& patience, std::size_t& boxes);

}  // namespace saddle
