#include "mesh/tree/inner_vertices.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Whether two corners are one feature: places are in units of the cell tree, of which doubles keep
/// no more digits.
bool is_same(const PolygonCorner& a, const PolygonCorner& b) {
  return a.corner == b.corner || glm::distance(a.place, b.place) < kNearly;
}

}  // namespace

std::optional<std::uint32_t> InnerVertices::between(const Leaf& leaf,
                                                    const PolygonChord& chord) const {
  if (chords_.empty()) return std::nullopt;
  const auto found = chords_.find(key_of(leaf));
  if (found == chords_.end()) return std::nullopt;
  const auto same = std::ranges::find_if(found->second, [&](const Chord& of_leaf) {
    return is_same(of_leaf.ends[0], chord[0]) && is_same(of_leaf.ends[1], chord[1]);
  });
  return same != found->second.end() ? std::optional(same->vertex) : std::nullopt;
}

}  // namespace saddle
