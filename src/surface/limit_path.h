// The path on which a limit at a point of the domain is extrapolated: of normals in normal.h, of
// colours' numbers in mesh/color.
#pragma once

#include <array>
#include <cstddef>

#include "base/vec.h"

namespace saddle {

/// The number of points, each at half the tau of the one before, from 0.2. The last is 1e-8 of the
/// way from the corner, where positions have about 8 digits left.
inline constexpr std::size_t kLimitSteps = 12;
/// Highest power of tau that is eliminated; more only amplify rounding.
inline constexpr std::size_t kHighestPower = 6;

/// Places on the way from `inside` to `corner`, ever closer to it: at tau^2 of the way, which makes
/// square-root limits analytic in tau.
inline std::array<dvec2, kLimitSteps> limit_path(const dvec2& corner, const dvec2& inside) {
  std::array<dvec2, kLimitSteps> path;
  double tau = 0.2;
  for (dvec2& place : path) {
    place = corner + (inside - corner) * (tau * tau);
    tau /= 2;
  }
  return path;
}

}  // namespace saddle
