// The limit of a colour's number at a point that has none, by the method of limit_normal() in
// surface/normal.h.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "base/vec.h"

namespace saddle {

inline constexpr std::size_t kLimitSteps = 12;

/// Places on the way from `inside` to `corner`, ever closer to it, at which numbers are needed.
std::array<dvec2, kLimitSteps> limit_path(const dvec2& corner, const dvec2& inside);

/// The limit of the numbers along such a path, by Richardson's extrapolation; nothing if there is
/// none.
std::optional<double> extrapolated_limit(std::span<const double> path);

}  // namespace saddle
