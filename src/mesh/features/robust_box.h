// What most of a set of numbers or points keep to, however far the rest goes.
#pragma once

#include <limits>
#include <span>
#include <vector>

#include "base/bounds.h"
#include "surface/surface.h"

namespace saddle {

/// The number that the given share (0 to 1) of the numbers are below; 0 if there are none. Changes
/// their order.
double quantile(std::span<double> numbers, double share);

/// In each coordinate, where all but the lowest and the highest twentieth of the points are. Where
/// that is longer than `longest`, and than the middle half of the points: a window so long that
/// shows the most of the points, and of each part of them that nothing joins to the others. The
/// points are finite; of none the box is empty.
Bounds robust_box(std::span<const dvec3> points,
                  const dvec3& longest = dvec3(std::numeric_limits<double>::infinity()));

/// robust_box() of a hundred of the points, spread over all: where orders of magnitude are asked
/// for, that tells them in no time.
Bounds rough_box(std::span<const dvec3> points);

/// Finite positions spread over a surface, alike on all sides of the middle of its domain: of what
/// changes its sign with those of u and v, or where they are exchanged, as many up as down.
std::vector<dvec3> balanced_positions(const Surface& surface, unsigned threads);

}  // namespace saddle
