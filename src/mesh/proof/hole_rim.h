// Holes that are thinner than what was searched for them: how far they reach around a place.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/sample_places.h"
#include "surface/surface.h"

namespace saddle {

/// From a place in a hole to its edge, in parameters, along kEightWays.
using HoleRim = std::array<dvec2, kEightWays.size()>;

/// A place between the nearest edges of a hole.
struct ThinHole {
  dvec2 middle;
  HoleRim rim;
};

/// The holes around undefined places, as far as `reach` each way and no farther than the domain.
/// Empty for a hole in which no line of 2 * `reach` through its place has two edges, and for some
/// where there are more than kMostFollowed.
std::vector<std::optional<ThinHole>> thin_holes(const Surface& surface,
                                                std::span<const dvec2> undefined,
                                                const dvec2& reach, unsigned threads);

/// The rim of a rectangle around its middle.
HoleRim rim_of_box(const dvec2& size);

/// The distance of a place in a hole from its rim, on a plane with these tangents: exact in a
/// straight slot, 0.92 of it or more in a round hole.
double depth_of(const HoleRim& rim, const dvec3& r_u, const dvec3& r_v);

}  // namespace saddle
