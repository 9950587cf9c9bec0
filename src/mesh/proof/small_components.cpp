#include "mesh/proof/small_components.h"

#include <algorithm>
#include <array>

#include <glm/common.hpp>

#include "eval/enclose.h"

namespace saddle {

namespace {

/// Halvings of a box, both ways taken together: 1/4096 of each side.
constexpr int kMaxDepth = 24;

/// An island is looked at closer, tile by tile, until so many of the tiles each way of what is left
/// are around what of it was found, or so many times.
constexpr int kTiles = 8;
constexpr int kEnoughTiles = 4;
constexpr int kMaxZooms = 6;
/// Cells of the grid, each way, on whose vertices an island is sampled then.
constexpr std::size_t kComponentSamples = 32;
constexpr std::size_t kBoxesForComponent = 40'000;
/// Parts of a tile that are followed: along the boundary of a strip there are as many as digits.
constexpr std::size_t kPartsOfTile = 16;

struct Part {
  ParameterBox box;
  std::size_t whole;  ///< which of the boxes it is a part of
};

class ComponentSearch {
 public:
  ComponentSearch(const Surface& surface, std::span<const ParameterBox> where, std::size_t& boxes,
                  unsigned threads, std::size_t most_parts)
      : surface_(surface),
        boxes_(boxes),
        most_parts_(most_parts),
        threads_(threads),
        enclosure_(surface.bounds, 3),
        found_(where.size()) {
    for (std::size_t k = 0; k < where.size(); ++k) parts_.push_back({where[k], k});
  }

  std::vector<std::optional<dvec2>> run() {
    for (int depth = 0; depth < kMaxDepth && !parts_.empty() && boxes_ > 0; ++depth) {
      std::erase_if(parts_, [&](const Part& part) { return is_undefined(part.box); });
      look_at_middles();
      std::erase_if(parts_, [&](const Part& part) { return found_[part.whole].has_value(); });
      thin_out();
      halve(depth % 2);
    }
    return std::move(found_);
  }

 private:
  /// Whether there is a proof of it; or nobody may look any more.
  bool is_undefined(const ParameterBox& box) {
    if (boxes_ == 0) return true;
    --boxes_;
    std::array<Interval, 3> position;
    enclosure_(range_between(box.low.x, box.high.x), range_between(box.low.y, box.high.y),
               position);
    return std::ranges::any_of(position,
                               [](const Interval& a) { return a.defined == Defined::No; });
  }

  void look_at_middles() {
    std::vector<dvec2> middles;
    for (const Part& part : parts_) middles.push_back(part.box.middle());
    const std::vector<SurfacePoint> points = evaluate(surface_, middles, threads_);
    for (std::size_t k = 0; k < parts_.size(); ++k) {
      if (is_finite(points[k].position)) found_[parts_[k].whole] = middles[k];
    }
  }

  /// Keeps as many parts of each box as may be followed, spread over all.
  void thin_out() {
    std::vector<Part> kept;
    for (std::size_t begin = 0; begin < parts_.size();) {
      std::size_t end = begin;
      while (end < parts_.size() && parts_[end].whole == parts_[begin].whole) ++end;
      const std::size_t count = std::min(end - begin, most_parts_);
      for (std::size_t k = 0; k < count; ++k) {
        kept.push_back(parts_[begin + k * (end - begin) / count]);
      }
      begin = end;
    }
    parts_ = std::move(kept);
  }

  void halve(int axis) {
    std::vector<Part> halves;
    for (const Part& part : parts_) {
      Part a = part;
      Part b = part;
      a.box.high[axis] = b.box.low[axis] = part.box.middle()[axis];
      halves.push_back(a);
      halves.push_back(b);
    }
    parts_ = std::move(halves);
  }

  const Surface& surface_;
  std::size_t& boxes_;
  std::size_t most_parts_;
  unsigned threads_;
  Enclosure enclosure_;
  std::vector<Part> parts_;
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
    // It may reach into the tiles beside those in which it was found.
    const dvec2 tile = (whole.high - whole.low) / double{kTiles};
    component.where = {glm::max(whole.low, low - tile), glm::min(whole.high, high + tile)};
    // A strip is narrow in one way only.
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
