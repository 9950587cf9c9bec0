#include "mesh/measure_many.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "eval/batch.h"
#include "mesh/leaf_loops.h"
#include "mesh/measure.h"
#include "mesh/vertex_columns.h"

namespace saddle {

namespace {

/// Leaves whose places are computed together: their columns (1.4 MB) stay in the outer caches.
constexpr std::size_t kBatch = 32 * kLeafBlock;

/// The four corners, the diagonal being from the first to the third.
std::array<std::uint32_t, 4> corners_of(const TwoTriangles& leaf, bool mirrored) {
  const auto& [a, b] = leaf.triangles;  // unless mirrored: 0 1 2 and 2 3 0 of the corners
  return mirrored ? std::array{a[0], a[2], a[1], b[2]} : std::array{a[0], a[1], a[2], b[1]};
}

/// Columns of the surface at the places of some leaves, one place of all of them after the other.
class Columns {
 public:
  /// `uv`: the parameters of place s of leaf i.
  template <class Function>
  Columns(const Surface& surface, std::size_t leaves, std::size_t places, unsigned threads,
          Function uv)
      : stride_(leaves), p_(places * stride_), q_(p_.size()) {
    Array<double> u(p_.size());
    Array<double> v(p_.size());
    for (std::size_t s = 0; s < places; ++s) {
      for (std::size_t i = 0; i < stride_; ++i) {
        const dvec2 at = uv(s, i);
        u[s * stride_ + i] = at.x;
        v[s * stride_ + i] = at.y;
      }
    }
    std::array<double*, 9> starts{};
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      columns_[k].resize(u.size());
      starts[k] = columns_[k].data();
    }
    evaluate_points(surface.tangents, u, v, starts, threads);
  }

  /// Where a place is in the triangles of its leaf, which begin at the corner of `low` or, turned,
  /// at the next.
  void set_place(std::size_t s, std::size_t i, const dvec2& part, bool turned) {
    p_[s * stride_ + i] = turned ? part.y : part.x;
    q_[s * stride_ + i] = turned ? 1 - part.x : part.y;
  }

  LeafPlaces places(std::size_t s, std::size_t begin) const {
    const std::size_t at = s * stride_ + begin;
    LeafPlaces places{p_.data() + at, q_.data() + at, {}};
    for (std::size_t k = 0; k < columns_.size(); ++k) places.surface[k] = columns_[k].data() + at;
    return places;
  }

 private:
  std::size_t stride_;
  Array<double> p_, q_;
  std::array<Array<double>, 9> columns_;
};

/// A block of leaves, and what is found at their places.
class Block {
 public:
  Block(const Surface& surface, const Grid& grid)
      : grid_(grid), points_(std::make_unique_for_overwrite<LeafPoints>()) {
    points_->scale = grid.local_scale;
    points_->front = surface.flip ? -1 : 1;
  }

  void put_corners(std::size_t i, const std::array<std::uint32_t, 4>& corners) {
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t corner = corners[k];
      put_vertex(grid_.local(corner), grid_.mesh.normal[corner], i, points_->corner[k]);
    }
  }

  /// Measures leaves whose first has the number `begin` in the columns.
  void measure(const Columns& columns, std::size_t begin, std::size_t places,
               std::span<std::optional<LeafDeviation>> result) const {
    const std::size_t count = result.size();
    LeafDeviations worst;
    std::fill_n(worst.distance.begin(), count, 0.0);
    std::fill_n(worst.foreseen.begin(), count, 0.0);
    std::fill_n(worst.chord.begin(), count, 0.0);
    std::fill_n(worst.is_known.begin(), count, 1.0);
    const MeasureLeaves loop = measure_loop(cpu_level());
    for (std::size_t s = 0; s < places; ++s) {
      loop(*points_, columns.places(s, begin), count, worst);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(worst.is_known[i] > 0)) continue;
      result[i] = {
          {worst.distance[i] / grid_.local_scale, degrees_of_chord(std::sqrt(worst.chord[i]))},
          worst.foreseen[i] / grid_.local_scale};
    }
  }

 private:
  const Grid& grid_;
  std::unique_ptr<LeafPoints> points_;
};

/// Where a place with such weights is: in the triangle 2 3 0. Outside of it the triangle is at no
/// height above the surface, and that is what places that are no numbers have.
dvec2 place_of(const dvec3& weights) {
  constexpr double kNowhere = std::numeric_limits<double>::quiet_NaN();
  if (!(std::min({weights.x, weights.y, weights.z}) >= 0)) return dvec2(kNowhere);
  return {weights.x, 1 - weights.z};
}

/// Calls f(begin, end) for parts of at most `length` of [0, count).
template <class Function>
void for_parts(std::size_t count, std::size_t length, Function f) {
  for (std::size_t begin = 0; begin < count; begin += length) {
    f(begin, std::min(begin + length, count));
  }
}

}  // namespace

std::vector<std::optional<LeafDeviation>> measure_many(const Surface& surface, const Grid& grid,
                                                       std::span<const TwoTriangles> leaves,
                                                       unsigned threads) {
  std::vector<std::optional<LeafDeviation>> result(leaves.size());
  Block block(surface, grid);
  for_parts(leaves.size(), kBatch, [&](std::size_t first, std::size_t last) {
    const auto batch = leaves.subspan(first, last - first);
    Columns columns(surface, batch.size(), kPlacesInLeaf, threads, [&](auto s, auto i) {
      const dvec2& part = batch[i].places[s];
      return batch[i].low * (1.0 - part) + batch[i].high * part;
    });
    for_parts(batch.size(), kLeafBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto corners = corners_of(batch[i], grid.mirrored);
        block.put_corners(i - begin, corners);
        const bool turned = grid.mesh.uv[corners[0]] != batch[i].low;
        for (std::size_t s = 0; s < kPlacesInLeaf; ++s) {
          columns.set_place(s, i, batch[i].places[s], turned);
        }
      }
      block.measure(columns, begin, kPlacesInLeaf,
                    std::span(result).subspan(first + begin, end - begin));
    });
  });
  return result;
}

std::vector<std::optional<LeafDeviation>> measure_places(const Surface& surface, const Grid& grid,
                                                         std::span<const PlaceOnTriangle> places,
                                                         unsigned threads) {
  std::vector<std::optional<LeafDeviation>> result(places.size());
  Block block(surface, grid);
  for_parts(places.size(), kBatch, [&](std::size_t first, std::size_t last) {
    const auto batch = places.subspan(first, last - first);
    Columns columns(surface, batch.size(), 1, threads, [&](auto, auto i) { return batch[i].uv; });
    for_parts(batch.size(), kLeafBlock, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        block.put_corners(i - begin, batch[i].corners);
        columns.set_place(0, i, place_of(batch[i].weights), false);
      }
      block.measure(columns, begin, 1, std::span(result).subspan(first + begin, end - begin));
    });
  });
  return result;
}

}  // namespace saddle
