// Parametrisations that are no surface but a straight line or a curve.
#pragma once

#include "mesh/grid/grid.h"

namespace saddle {

/// Throws Error (Nothing) if the tangents are parallel wherever they were looked at: a straight
/// line or a curve.
void require_two_dimensional(const Surface& surface, const Grid& grid, unsigned threads);

}  // namespace saddle
