// Parametrisations that are no surface, told apart so that the message can say which.
#pragma once

#include "mesh/grid/grid.h"

namespace saddle {

/// Factors that give each coordinate an extent of 1, or leave it alone where it has none.
dvec3 axis_scale(const Bounds& bounds);

/// Throws Error (Nothing) if the tangents are parallel wherever they were looked at: a straight
/// line or a curve.
void require_two_dimensional(const Surface& surface, const Grid& grid, unsigned threads);

}  // namespace saddle
