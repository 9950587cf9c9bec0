// Vertices inside of leaves: where features cross, end or turn, each sheet of the surface has a
// vertex of its own, so that its edge need not be one chord across the leaf.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "mesh/tree/leaf.h"
#include "mesh/tree/polygon.h"

namespace saddle {

/// The chord of a sub-polygon, counter-clockwise.
using PolygonChord = std::array<PolygonCorner, 2>;

/// The inner vertices of leaves. One belongs to a chord of a sub-polygon and lies between the
/// chord's ends. The halves of a leaf have none.
class InnerVertices {
 public:
  /// The vertex on a chord, if it has one. A feature that was found again, on the half of a side,
  /// has another vertex at the same place. The sheet beyond has the same chord the other way round.
  std::optional<std::uint32_t> between(const Leaf& leaf, const PolygonChord& chord) const;
  void add(const Leaf& leaf, const PolygonChord& chord, std::uint32_t vertex) {
    chords_[key_of(leaf)].push_back({chord, vertex});
  }
  bool has(const Leaf& leaf) const { return !chords_.empty() && chords_.contains(key_of(leaf)); }

 private:
  struct Chord {
    PolygonChord ends;
    std::uint32_t vertex;
  };
  using Key = std::array<std::uint32_t, 4>;
  static Key key_of(const Leaf& leaf) {
    return {leaf.low.u, leaf.low.v, leaf.high().u, leaf.high().v};
  }
  std::map<Key, std::vector<Chord>> chords_;
};

}  // namespace saddle
