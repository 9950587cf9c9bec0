// The limits that a mesh must keep, and sizes below which errors do not count.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "mesh/model/tolerance.h"
#include "mesh/tree/triangle_budget.h"

namespace saddle {

/// Jumps and folds are not looked for in a leaf with a diameter of at most 2 tolerances, a pixel of
/// a picture. Turns of normals along such chords do not count, nor across leaves as thin. Where
/// sheets meet at a point, normals turn however often a leaf is halved; at the shoulder of a front
/// they turn within less than a pixel.
inline constexpr double kSeenTurn = 2;
/// In root cells: a leaf that a feature cuts is slender if it is 32 times as long as wide. Halvings
/// have found the place of the feature by then.
inline constexpr std::uint32_t kSlender = 32;

/// The angle between normals without their signs. Across a cusp the normal jumps to its opposite
/// while the tangent plane is continuous; halving does not reduce that angle.
inline double turn_of_line(double degrees) {
  return std::min(degrees, 180 - degrees);
}

/// The limits that each leaf of a mesh keeps. They stay the same from the first leaf to the last.
struct CellLimits {
  Tolerance tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  TriangleLimit triangles = {};
  std::optional<Bounds> clip = {};  ///< errors outside of this box do not count
  std::vector<std::uint8_t> seen_u,
      seen_v;  ///< the grid's lines that are drawn or the domain's ends
  unsigned threads = 0;
  double share = 1e-3;  ///< the tolerance as a share of the surface's diagonal
  std::size_t leaves_at_a_time = std::numeric_limits<std::size_t>::max();  ///< of MeshRequest
};

/// The limit for halvings that reduce the error of normals alone: 250,000 triangles, about half the
/// pixels of an 800 x 600 picture.
inline TriangleLimit limit_for_normals(const TriangleLimit& limit) {
  constexpr std::size_t kEnough = 250'000;
  return {std::min(limit.triangles, kEnough), limit.is_refined};
}

}  // namespace saddle
