// The limits that a mesh keeps, and the sizes below which errors do not count.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "mesh/model/tolerance.h"

namespace saddle {

/// A leaf that is no larger than so many tolerances is smaller than what may be missing: nobody
/// looks for jumps and folds in it.
inline constexpr double kVisible = 2;

/// How normals turn along what is no longer than so many tolerances, a pixel of a picture, does not
/// matter, nor across what is no thicker. At a point where sheets meet they turn however often a
/// leaf is halved, and at the shoulder of a front within a width that no picture shows. Of waves
/// that are five pixels long a picture shows no more with half as much.
inline constexpr double kSeenTurn = 2;

/// An angle between normals but for their signs: across a cusp the normal jumps to its opposite
/// while the tangent plane goes on, and no halving mends that.
inline double turn_of_line(double degrees) {
  return std::min(degrees, 180 - degrees);
}

/// The limits that each leaf of a mesh keeps. They stay the same from the first leaf to the last.
struct RefineOptions {
  Tolerance tolerance;
  double normal_tolerance = 180;  ///< degrees between interpolated and exact normals
  std::size_t max_triangles = 4'000'000;
  std::optional<Bounds> clip = {};  ///< errors outside of this box do not count
  std::vector<std::uint8_t> seen_u,
      seen_v;  ///< the grid's lines that are drawn or the domain's ends
  unsigned threads = 0;
  double share = 1e-3;  ///< the tolerance as a share of the surface's diagonal
};

/// Triangles up to which leaves are halved for their normals alone: half as many as a picture of
/// 800 x 600 has pixels, or a share of those that are allowed if that is more.
inline std::size_t allowed_for_normals(std::size_t max_triangles) {
  constexpr std::size_t kEnough = 250'000;
  constexpr std::size_t kShare = 16;
  return std::min(max_triangles, std::max(kEnough, max_triangles / kShare));
}

}  // namespace saddle
