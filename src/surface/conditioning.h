// How many digits the tangents of a surface leave to its curvatures.
#pragma once

#include <span>

#include "surface/surface.h"

namespace saddle {

/// |r_u x r_v| below this part of |r_u| |r_v|, and tangents below this part of the usual, cost
/// curvatures more than half of their digits.
inline constexpr double kWellConditioned = 1e-3;
inline constexpr double kShortTangent = 1e-5;

/// The median length of a tangent.
double usual_length(std::span<const SurfacePoint> points, dvec3 SurfacePoint::*tangent);

}  // namespace saddle
