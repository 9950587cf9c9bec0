// Leaves of the cell tree: rectangles between dyadic points.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "mesh/tree/leaf_state.h"

namespace saddle {

/// The side of a root cell in units: a power of 2, so that it can be halved 16 times in each
/// direction.
inline constexpr std::uint32_t kCellUnit = 1U << 16;

/// A place in units: line k of the root grid is at k * kCellUnit.
struct DyadicPoint {
  std::uint32_t u = 0;
  std::uint32_t v = 0;
  bool operator==(const DyadicPoint&) const = default;
};

/// The nine vertices from which the error indicator of a leaf is made, counter-clockwise in (u, v)
/// from its low corner. Leaves that passed it may have lost all but their corners.
struct SampleVertices {
  /// Not known yet, or forgotten.
  static constexpr std::uint32_t kUnasked = ~std::uint32_t{0};

  std::array<std::uint32_t, 4> corner = {kUnasked, kUnasked, kUnasked, kUnasked};
  /// Middles of sides; an end of a side that is too short to halve.
  std::array<std::uint32_t, 4> side = {kUnasked, kUnasked, kUnasked, kUnasked};
  std::uint32_t centre = kUnasked;

  /// Calls f(vertex) for the samples at middles that are known.
  template <class F>
  void for_middles(F f) const {
    for (const std::uint32_t vertex : side) {
      if (vertex != kUnasked) f(vertex);
    }
    if (centre != kUnasked) f(centre);
  }
  void forget_all_but_corners() {
    side.fill(kUnasked);
    centre = kUnasked;
  }
  /// The samples of a half that the whole leaf has, too.
  SampleVertices of_half(bool along_u, bool is_lower) const;
};

/// A cell of the mesh. A fine mesh has millions.
struct Leaf {
  DyadicPoint low;
  SampleVertices samples = {};     ///< known once the leaf was estimated
  std::uint32_t followed_at = 0;   ///< revision at which features of its sides were followed
  std::uint32_t validated_at = 0;  ///< revision at which it was validated with its polygon
  float known_error = 0;           ///< the error indicator of distances, in tolerances
  /// Factors on the error indicator of distances and of normals: the product of the sampled errors
  /// of ancestors, in tolerances, each clamped to [1, 4].
  float safety = 1;
  float normal_safety = 1;
  std::uint16_t polygon_size = 0;  ///< vertices of its polygon at `validated_at`, 65,535 at most
  LeafState state = {};
  std::uint8_t halved_u = 0;           ///< halvings of its root cell along u
  std::uint8_t halved_v = 0;           ///< along v
  std::uint8_t stagnation = 0;         ///< consecutive halvings that did not reduce the distance
  std::uint8_t normal_stagnation = 0;  ///< the same of the error of normals
  std::uint8_t sought = 0;             ///< halvings of the root cell that led to a counterexample

  std::uint32_t size_u() const { return kCellUnit >> halved_u; }
  std::uint32_t size_v() const { return kCellUnit >> halved_v; }
  DyadicPoint high() const { return {low.u + size_u(), low.v + size_v()}; }
  DyadicPoint middle() const { return {low.u + size_u() / 2, low.v + size_v() / 2}; }
  /// Whether middle() lies inside. That of the narrowest leaves is on a side, or a corner.
  bool has_middle() const { return std::min(size_u(), size_v()) > 1; }
  /// Counter-clockwise in (u, v), from the low corner.
  std::array<DyadicPoint, 4> corners() const {
    const DyadicPoint end = high();
    return {low, DyadicPoint{end.u, low.v}, end, DyadicPoint{low.u, end.v}};
  }
};
static_assert(sizeof(Leaf) == 72);

}  // namespace saddle
