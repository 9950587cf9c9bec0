#include "mesh/tree/inner_vertices.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace saddle {

namespace {

/// Features nearer to each other than this, in units of the cell tree, are one.
constexpr double kOneFeature = 1e-6;

}  // namespace

std::optional<std::uint32_t> InnerVertices::after(const Leaf& leaf,
                                                  const PolygonCorner& start) const {
  if (chords_.empty()) return std::nullopt;
  const auto found = chords_.find(key_of(leaf));
  if (found == chords_.end()) return std::nullopt;
  const std::vector<Chord>& chords = found->second;
  const auto same = std::ranges::find_if(
      chords, [&](const Chord& chord) { return chord.start.corner == start.corner; });
  if (same != chords.end()) return same->vertex;
  const auto near = std::ranges::find_if(chords, [&](const Chord& chord) {
    return glm::distance(chord.start.place, start.place) < kOneFeature;
  });
  return near != chords.end() ? std::optional(near->vertex) : std::nullopt;
}

}  // namespace saddle
