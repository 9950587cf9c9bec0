// The limit of a colour's number at a point that has none, by the method of limit_normal() in
// surface/normal.h.
#pragma once

#include <optional>
#include <span>

namespace saddle {

/// The limit of the numbers along a limit_path(), by Richardson's extrapolation; nothing if there
/// is none.
std::optional<double> extrapolated_limit(std::span<const double> path);

}  // namespace saddle
