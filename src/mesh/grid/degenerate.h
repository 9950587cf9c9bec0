// Parametrisations that are no surface but a straight line or a curve.
#pragma once

#include "mesh/grid/grid.h"

namespace saddle {

/// Vertices, or centres of cells, that are looked at where all vertices may be singular, as on a
/// sphere of one cell.
inline constexpr std::size_t kTried = 1024;

/// Throws Error (Nothing) if the tangents are parallel wherever they were looked at: a straight
/// line or a curve.
void require_two_dimensional(const Surface& surface, const Grid& grid, unsigned threads);

}  // namespace saddle
