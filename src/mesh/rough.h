// Single points at which a surface is defined and its tangents are not, as the apex of a cone
// z = hypot(u, v) is.
#pragma once

#include <vector>

#include "surface/surface.h"

namespace saddle {

/// Points that boxes around which bounds leave room for a jump of a tangent shrink to, for a
/// surface of second order, if these are few. None where the surface is not defined.
std::vector<dvec2> find_rough_points(const Surface& surface, unsigned threads);

}  // namespace saddle
