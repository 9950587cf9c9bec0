#include "mesh/proof/small_components.h"

#include <algorithm>

#include <glm/common.hpp>

#include "surface/box_subdivision.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Halvings of a box, both ways taken together: 1/4096 of each side.
constexpr int kMaxDepth = 24;

/// A zoom divides a box into 8 x 8 tiles, and ends when the component spans 4 of them each way, or
/// after 6 zooms.
constexpr int kTiles = 8;
constexpr int kEnoughTiles = 4;
constexpr int kMaxZooms = 6;
/// Cells each way of the grid on whose vertices the component is sampled.
constexpr std::size_t kComponentSamples = 32;
constexpr std::size_t kBoxesForComponent = 40'000;
/// Parts of a tile that are followed. Along the boundary of a strip there would be ever more.
constexpr std::size_t kPartsOfTile = 16;

struct Part {
  ParameterBox box;
  std::size_t whole;  ///< number of the box that it is a part of
};

std::vector<Part> parts_of(std::span<const ParameterBox> boxes) {
  std::vector<Part> parts;
  for (std::size_t k = 0; k < boxes.size(); ++k) parts.push_back({boxes[k], k});
  return parts;
}

class ComponentSearch {
 public:
  ComponentSearch(const Surface& surface, std::span<const ParameterBox> where, std::size_t& boxes,
                  unsigned threads, std::size_t most_parts)
      : surface_(surface),
        boxes_(boxes),
        most_parts_(most_parts),
        threads_(threads),
        enclosure_(surface, Bounded::Position),
        search_(parts_of(where)),
        found_(where.size()) {}

  std::vector<std::optional<dvec2>> run() {
    while (!search_.open().empty() && search_.depth() < kMaxDepth && boxes_ > 0) {
      search_.test([this](const Part& part) { return prove_undefined(part.box); });
      look_at_middles();
      search_.test([this](const Part& part) {
        return found_[part.whole] ? ProofOutcome::Proved : ProofOutcome::Open;
      });
      thin_out();
      search_.halve_in_turn();
    }
    return std::move(found_);
  }

 private:
  /// Refuted: nothing of the surface is in the box, or the budget is spent.
  ProofOutcome prove_undefined(const ParameterBox& box) {
    if (boxes_ == 0) return ProofOutcome::Refuted;
    --boxes_;
    return least_defined(enclosure_.enclose(box)) == Defined::No ? ProofOutcome::Refuted
                                                                 : ProofOutcome::Open;
  }

  void look_at_middles() {
    std::vector<dvec2> middles;
    for (const Part& part : search_.open()) middles.push_back(part.box.middle());
    const std::vector<SurfacePoint> points = evaluate(surface_, middles, threads_);
    for (std::size_t k = 0; k < middles.size(); ++k) {
      if (is_finite(points[k].position)) found_[search_.open()[k].whole] = middles[k];
    }
  }

  /// Keeps at most `most_parts_` parts of each box, evenly spread over its parts.
  void thin_out() {
    std::vector<Part>& parts = search_.open();
    std::vector<Part> kept;
    for (std::size_t begin = 0; begin < parts.size();) {
      std::size_t end = begin;
      while (end < parts.size() && parts[end].whole == parts[begin].whole) ++end;
      const std::size_t count = std::min(end - begin, most_parts_);
      for (std::size_t k = 0; k < count; ++k) {
        kept.push_back(parts[begin + k * (end - begin) / count]);
      }
      begin = end;
    }
    parts = std::move(kept);
  }

  const Surface& surface_;
  std::size_t& boxes_;
  std::size_t most_parts_;
  unsigned threads_;
  SurfaceEnclosure enclosure_;
  BoxSubdivision<Part> search_;
  std::vector<std::optional<dvec2>> found_;
};

/// The tiles of a box, each way.
std::vector<ParameterBox> tiles_of(const ParameterBox& box) {
  std::vector<ParameterBox> tiles;
  for (int k = 0; k < kTiles * kTiles; ++k) {
    const dvec2 low = dvec2(k % kTiles, k / kTiles) / double{kTiles};
    tiles.push_back(
        {glm::mix(box.low, box.high, low), glm::mix(box.low, box.high, low + 1.0 / kTiles)});
  }
  return tiles;
}

}  // namespace

std::vector<std::optional<dvec2>> find_defined(const Surface& surface,
                                               std::span<const ParameterBox> where,
                                               std::size_t& boxes, unsigned threads,
                                               std::size_t most_parts) {
  return ComponentSearch(surface, where, boxes, threads, most_parts).run();
}

std::optional<SmallComponent> find_small_component(const Surface& surface, unsigned threads) {
  const Domain& d = surface.domain;
  SmallComponent component{{glm::min(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1)),
                            glm::max(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1))},
                           {}};
  std::size_t boxes = kBoxesForComponent;
  std::vector<dvec2> known;
  for (int zoom = 0; zoom < kMaxZooms; ++zoom) {
    const ParameterBox whole = component.where;
    dvec2 low = whole.high;
    dvec2 high = whole.low;
    for (const auto& found : find_defined(surface, tiles_of(whole), boxes, threads, kPartsOfTile)) {
      if (!found) continue;
      known.push_back(*found);
      low = glm::min(low, *found);
      high = glm::max(high, *found);
    }
    if (low.x > high.x) break;
    // The component may reach into the tiles beside those in which it was found.
    const dvec2 tile = (whole.high - whole.low) / double{kTiles};
    component.where = {glm::max(whole.low, low - tile), glm::min(whole.high, high + tile)};
    // A strip is narrow in one direction only.
    const dvec2 tiles = (high - low) / tile;
    if (std::min(tiles.x, tiles.y) >= kEnoughTiles - 1) break;
  }
  if (known.empty()) return std::nullopt;
  const auto [low, high] = component.where;
  for (const double v : even_lines(low.y, high.y, kComponentSamples)) {
    for (const double u : even_lines(low.x, high.x, kComponentSamples)) known.emplace_back(u, v);
  }
  for (const SurfacePoint& point : evaluate(surface, known, threads)) {
    if (is_finite(point.position)) component.positions.push_back(point.position);
  }
  return component;
}

}  // namespace saddle
