// Leaves: rectangles of a grid that is refined here and there, in whole coordinates.
#pragma once

#include <array>
#include <cstdint>

#include "mesh/tree/leaf_state.h"

namespace saddle {

/// The side of a cell of the root grid; a cell can be halved as often as this is divided by 2.
inline constexpr std::uint32_t kCellUnit = 1U << 16;

/// (u, v) in units: line k of the root grid is at k * kCellUnit.
struct DyadicPoint {
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  bool operator==(const DyadicPoint&) const = default;
};

/// The vertices that a leaf is judged by, counter-clockwise in (u, v) from its low corner.
struct SampleVertices {
  /// Not known: the cell tree is to be asked.
  static constexpr std::uint32_t kUnasked = ~std::uint32_t{0};

  std::array<std::uint32_t, 4> corner = {kUnasked, kUnasked, kUnasked, kUnasked};
  /// In the middles of sides; on one that is too short for a middle, one of its ends.
  std::array<std::uint32_t, 4> side = {kUnasked, kUnasked, kUnasked, kUnasked};
  std::uint32_t centre = kUnasked;

  /// Those of a half that are the whole's as well.
  SampleVertices of_half(bool across_u, bool is_lower) const;
};

/// A rectangle of the refined grid.
struct Leaf {
  DyadicPoint low, high;
  SampleVertices samples = {};  ///< known once the leaf was estimated
  LeafState state = {};
  std::uint8_t stagnation = 0;         ///< consecutive halvings that did not reduce the distance
  std::uint8_t normal_stagnation = 0;  ///< the same of the error of normals
  std::uint8_t sought = 0;             ///< halvings of the root cell until a sample was defined
  std::uint32_t bisected = 0;          ///< revision at which features of its sides were followed
  std::uint32_t measured = 0;          ///< revision at which it was validated with its polygon
  std::uint32_t polygon_size = 0;      ///< vertices of its cell polygon at that revision
  float known_error = 0;               ///< the error indicator when halving ended, in tolerances
  /// Largest ratio of sampled error to tolerance among its ancestors: distances and normals.
  float safety = 1;
  float normal_safety = 1;

  std::uint32_t size_u() const { return high.u - low.u; }
  std::uint32_t size_v() const { return high.v - low.v; }
  DyadicPoint middle() const { return {low.u + size_u() / 2, low.v + size_v() / 2}; }
  /// Counter-clockwise in (u, v), from the low corner.
  std::array<DyadicPoint, 4> corners() const {
    return {low, DyadicPoint{high.u, low.v}, high, DyadicPoint{low.u, high.v}};
  }
};

}  // namespace saddle
