// Limits that several parts of the mesher share.
#pragma once

#include <cstddef>
#include <limits>

namespace saddle {

/// Places of a kind that a report names; it counts the others.
inline constexpr std::size_t kMaxListed = 1000;

/// Normals that differ by no more, in degrees, are one normal. A smaller angle is no visible
/// crease, and one corner in place of four keeps smooth poles smooth.
inline constexpr double kCreaseDegrees = 1;

/// The rounding error of a coordinate, as a part of it: that of a few operations. Differences up to
/// it do not count.
inline constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();

}  // namespace saddle
