// What a surface does on the way to a place in the (u, v) plane.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/proof/continuity.h"
#include "surface/surface.h"

namespace saddle {

/// Places that diverge() looks at on each of its lines.
inline constexpr std::size_t kLooksOnTheWay = 6;

/// Whether the surface goes to infinity on the way from the second end of each line to the first.
/// Seen from places ever closer to it, the surface moves by less and less if it arrives somewhere,
/// as sqrt does; ln(x), which is no more than -745 at the smallest of doubles, moves on by as much
/// each time, always the same way. What moves by less than `delta` arrives.
std::vector<bool> diverge(const Surface& surface, std::span<const Line> lines, double delta,
                          unsigned threads);

/// Bisects lines from a place where the surface is defined, and in a box, to one where it is not:
/// the last places known to be so, after so many halvings.
std::vector<dvec2> last_defined(const Surface& surface, std::span<const Line> lines, int halvings,
                                unsigned threads, const std::optional<Bounds>& box = {});

}  // namespace saddle
