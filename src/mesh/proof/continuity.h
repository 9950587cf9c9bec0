// Proves by interval arithmetic that a surface, or its normal, is continuous along lines of
// parameters.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/tolerances.h"
#include "surface/surface.h"

namespace saddle {

/// A straight line of parameters.
using Line = std::array<dvec2, 2>;

/// A line, or a part of one.
struct LinePart {
  std::size_t line;  ///< its number
  Line part;
  /// Which end is known to be beside a break: there is no proof there.
  std::optional<std::size_t> broken_end = {};
};

/// Parts of these, apart from each other, on which the surface is proved neither to be continuous
/// nor to stay within `delta`, so that it jumps by no more: as short as doubles go, or as many as
/// are worth a search, or what is left after some halvings. Those of a line follow each other, in
/// the order of lines. Adds to `boxes` how many were tried.
std::vector<LinePart> unproved(const Surface& surface, std::vector<LinePart> lines, double delta,
                               std::size_t& boxes, int halvings = kAllHalvings);

/// Lines on which there may be creases.
struct UnprovedNormals {
  std::vector<std::size_t> lines;  ///< their numbers, in order
  /// Tangents are continuous in a box around all lines: a crease is where r_u x r_v goes through 0,
  /// and the normal turns to its opposite.
  bool only_cusps = false;
};

/// The lines along which it is not proved that the tangents are continuous and r_u x r_v is not 0:
/// elsewhere there are no creases, nor cusps. Where proofs are in vain, or cost more than a look at
/// the lines, most of these are not tried. Adds to `boxes` how many proofs were.
UnprovedNormals unproved_normals(const Surface& surface, std::span<const Line> lines,
                                 std::size_t& boxes);

}  // namespace saddle
