// What most of a set of numbers or points keep to, however far the rest goes.
#pragma once

#include <limits>
#include <span>

#include "mesh/mesh.h"

namespace saddle {

/// The number that the given share (0 to 1) of the numbers are below; 0 if there are none. Changes
/// their order.
double quantile(std::span<double> numbers, double share);

/// In each coordinate, where all but the lowest and the highest twentieth of the points are. More
/// is left out, up to a quarter at either end, where the box is else longer than `longest`. The
/// points are finite.
Bounds robust_box(std::span<const dvec3> points,
                  const dvec3& longest = dvec3(std::numeric_limits<double>::infinity()));

}  // namespace saddle
