// Tells jumps and poles from steep slopes, and creases from bends, and finds the rim of the
// surface, along straight lines in the (u, v) plane.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/continuity.h"
#include "mesh/mesh.h"
#include "surface/surface.h"

namespace saddle {

enum class Break : std::uint8_t { None, Jump, Pole };

/// What is found on a line, and between which neighbours in double precision.
struct Found {
  Break kind = Break::None;
  Line ends{dvec2(0), dvec2(0)};  ///< the first is the one nearer to the line's first end
  bool has_more = false;          ///< there are others on the line
  bool is_cusp = false;           ///< the normal goes to its opposite: the tangents do not jump
};

/// Follows the larger half of the gap between the positions at the ends of each line until both
/// halves are below `delta`, which shows that the surface is continuous there, or the parameters
/// have run out of digits: then it jumps, or goes to infinity if the gap has grown on the way.
/// Nothing is found on a line with an end where the surface is not defined. What samples do not
/// show because they are alike is looked for where bounds do not prove that the surface is
/// continuous. Adds to `work` the points and boxes that were looked at.
std::vector<Found> find_breaks(const Surface& surface, std::span<const Line> lines, double delta,
                               unsigned threads, std::size_t& work);

/// Whether the surface goes to infinity on the way from the second end of each line to the first.
/// Seen from places ever closer to it, the surface moves by less and less if it arrives somewhere,
/// as sqrt does; ln(x), which is no more than -745 at the smallest of doubles, moves on by as much
/// each time, always the same way. What moves by less than `delta` arrives.
std::vector<bool> diverge(const Surface& surface, std::span<const Line> lines, double delta,
                          unsigned threads);

/// As find_breaks(), of unit normals: where they jump by more than kCreaseDegrees the surface has a
/// crease, or, if to their opposites, a cusp. `normals`: along r_u x r_v, at the ends of each line.
std::vector<Found> find_creases(const Surface& surface, std::span<const Line> lines,
                                std::span<const std::array<dvec3, 2>> normals, unsigned threads,
                                std::size_t& work);

/// Bisects lines from a place where the surface is defined, and in a box, to one where it is not:
/// the last places known to be so, after so many halvings.
std::vector<dvec2> last_defined(const Surface& surface, std::span<const Line> lines, int halvings,
                                unsigned threads, const std::optional<Bounds>& box = {});

}  // namespace saddle
