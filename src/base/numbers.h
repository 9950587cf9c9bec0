// Names of numbers that stand for nothing, or for no bound.
#pragma once

#include <cstdint>
#include <limits>

namespace saddle {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();
inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
/// The index of nothing.
inline constexpr std::uint32_t kNoIndex = std::numeric_limits<std::uint32_t>::max();

}  // namespace saddle
