// When the cross product of two tangents counts as zero. Only a constant, also for loops that are
// compiled once for each CPU level.
#pragma once

namespace saddle {

/// |r_u x r_v| at most this times the local scale of |r_u| |r_v| counts as zero: below it the
/// direction has lost about half of a double's digits to cancellation.
inline constexpr double kDegenerateCross = 1e-7;

}  // namespace saddle
