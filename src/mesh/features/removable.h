// Places at which a formula is 0/0, or rounding instead, but all around agrees on what it should
// be, as sin(u)/u does at 0.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace saddle {

/// What is beside a place.
struct Beside {
  bool is_defined = false;     ///< the surface, somewhere beside
  std::optional<dvec3> limit;  ///< the position that all beside it agree on
};

/// Looks a millionth of the ranges to all sides of places. `diagonal`: of a box around the surface.
/// Adds to `count` how many places were looked at.
std::vector<Beside> look_beside(const Surface& surface, std::span<const dvec2> places,
                                double diagonal, unsigned threads, std::size_t& count);

/// Whether a position is rounding, by what its tangents say: the last digit of the parameters moves
/// it by more than what places that agree differ by. So does that of (u^3 - v^3) / (u - v) where u
/// and v are neighbours in double precision.
bool is_rounding(const SurfacePoint& point, const dvec2& uv, double diagonal);

}  // namespace saddle
