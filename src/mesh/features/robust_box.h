// Robust bounds: boxes around most points of a set, however far the others lie.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "surface/surface.h"

namespace saddle {

/// The quantile of some numbers at `share`, 0 to 1; 0 if there are none. Changes their order.
double quantile(std::span<double> numbers, double share);

/// In each coordinate, the range without the lowest and the highest 5 % of the points. If it is
/// longer than both `longest` and the range of the middle half, a window of the longer of these
/// that shows the most of the points and of each of their clusters. The points are finite; the box
/// of none is empty.
Bounds robust_box(std::span<const dvec3> points,
                  const dvec3& longest = dvec3(std::numeric_limits<double>::infinity()));

/// robust_box() of a hundred of the points, spread over all: an order of magnitude.
Bounds rough_box(std::span<const dvec3> points);

/// Finite positions at parameters that are symmetric about the middle of the domain: a surface that
/// is odd in u or v has as many above as below.
std::vector<dvec3> balanced_positions(const Surface& surface, unsigned threads);

}  // namespace saddle
