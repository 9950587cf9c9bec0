// Single points at which the tangents of a surface are not defined, or nothing of it is.
#pragma once

#include <vector>

#include "surface/surface.h"

namespace saddle {

struct NonsmoothPoints {
  /// The surface is defined there, as at the apex of z = hypot(u, v), or has a limit there, but a
  /// normal for each side: z = (u^2 + v^2) / hypot(u, v).
  std::vector<dvec2> conical;
  std::vector<dvec2> without_limit;  ///< it has no limit: PointSingularity::Kind::NoLimit
};

/// Points to which boxes shrink around which bounds leave room for a jump of a tangent, for a
/// surface of second order, if these are few. `diagonal`: of a box around the surface.
NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads);

}  // namespace saddle
