// What most of a set of numbers or points keep to, however far the rest goes.
#pragma once

#include <span>
#include <vector>

#include "mesh/mesh.h"

namespace saddle {

/// The number that the given share (0 to 1) of the numbers are below; 0 if there are none. Changes
/// their order.
double quantile(std::vector<double>& numbers, double share);

/// In each coordinate, where all but the lowest and the highest twentieth of the points are. The
/// points are finite.
Bounds robust_box(std::span<const dvec3> points);

}  // namespace saddle
