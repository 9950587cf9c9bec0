// The vectors whose gaps are bisected: positions or normals.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <limits>

#include "mesh/model/tolerances.h"
#include "surface/normal.h"
#include "surface/surface.h"

namespace saddle {

enum class Discontinuity : std::uint8_t { None, Jump, Pole };

/// The distance of two values, also where its square would overflow.
inline double gap_between(const dvec3& a, const dvec3& b) {
  return safe_length(a - b);
}

/// The vector that may jump, and how it is searched.
struct BisectedVector {
  std::function<dvec3(const SurfacePoint&)> value;  ///< not finite where it is undefined
  /// A smooth function that changes its sign where the vector jumps: of the values at the ends of
  /// the rest of a line, and of a point there. Without it lines are halved.
  std::function<double(const std::array<dvec3, 2>&, const SurfacePoint&)> height;
  double delta;        ///< a smaller gap is closed
  double beyond;       ///< a jump's end moves outward to values that differ from it by more
  bool are_positions;  ///< the vectors are positions
  int plain;           ///< halvings before heights are used
  /// Halvings of a line. A gap that is left before the last digits counts as a jump.
  int halvings = kAllHalvings;
  /// The first part of a line is followed if its gap is larger than this; else the larger part.
  double first_gap = std::numeric_limits<double>::infinity();
};

}  // namespace saddle
