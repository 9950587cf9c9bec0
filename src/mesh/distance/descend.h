// Descents of points in space to the surface near given parameters.
// Source: D. Marquardt, "An algorithm for least-squares estimation of nonlinear parameters", 1963.
#pragma once

#include <span>
#include <vector>

#include "mesh/model/placed_error.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A point in space, and where the surface is searched for what is nearest to it.
struct Descending {
  dvec3 from;           ///< the point
  dvec2 start;          ///< where the descent starts
  ParameterBox within;  ///< and where it stays
  double enough = 0;    ///< it ends below this distance
};

/// The nearest place that each descent comes to, after as many steps at most; infinitely far where
/// the surface is undefined at the start.
std::vector<PlacedError> descend(const Surface& surface, std::span<const Descending> points,
                                 int steps, unsigned threads);

}  // namespace saddle
