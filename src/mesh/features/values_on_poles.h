// Values of a formula that are no part of a sheet: on lines that rounding makes as wide as kSliver,
// as that of floor(cos(u)) at u=0, and on poles, as that of (u==v)?0:1/(u-v).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace saddle {

/// Whether a surface may have a value on a pole: it has a condition, and no bounds.
bool may_have_values_on_poles(const Surface& surface);

/// Whether places have values on poles: from most sides the surface goes to infinity there.
/// `positions`: at the places. `delta`: a move of less converges. Adds to `work` the number of
/// points evaluated.
std::vector<bool> are_on_poles(const Surface& surface, std::span<const dvec2> places,
                               std::span<const dvec3> positions, double delta, unsigned threads,
                               std::size_t& work);

}  // namespace saddle
