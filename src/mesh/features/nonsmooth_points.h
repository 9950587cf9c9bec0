// Isolated points at which a surface is not smooth: tips, and points where creases cross.
#pragma once

#include <vector>

#include "surface/surface.h"

namespace saddle {

struct NonsmoothPoints {
  /// Conical points: the surface is defined or has a limit there, and a different normal on each
  /// side, as at the apex of z = hypot(u, v).
  std::vector<dvec2> conical;
  std::vector<dvec2> without_limit;  ///< PointSingularity::Kind::Essential and Pole
};

/// The points to which boxes shrink in which bounds do not prove tangents to be continuous, but
/// for those on curves. Where curves cross, more operations break a box than along either. For a
/// surface of second order. `diagonal`: of a box around the surface.
NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads);

}  // namespace saddle
