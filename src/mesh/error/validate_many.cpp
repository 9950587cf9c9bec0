#include "mesh/error/validate_many.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/numbers.h"
#include "eval/batch.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/error/error_loops.h"
#include "mesh/grid/vertex_columns.h"

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

  /// Sets a place in the triangles of its leaf, which begin at the corner of `low` or, turned, at
  /// the next.
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

/// A block of leaves, validated at their places.
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

  /// Validates leaves. The first has the number `begin` in the columns.
  void measure(const Columns& columns, std::size_t begin, std::size_t places,
               std::span<std::optional<LeafError>> result) const {
    const std::size_t count = result.size();
    LeafSampledErrors worst;
    std::fill_n(worst.distance.begin(), count, 0.0);
    std::fill_n(worst.predicted.begin(), count, 0.0);
    std::fill_n(worst.chord.begin(), count, 0.0);
    std::fill_n(worst.is_known.begin(), count, 1.0);
    const ValidateLeaves loop = validate_loop(cpu_level());
    for (std::size_t s = 0; s < places; ++s) {
      loop(*points_, columns.places(s, begin), count, worst);
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (!(worst.is_known[i] > 0)) continue;
      result[i] = {
          {worst.distance[i] / grid_.local_scale, degrees_of_chord(std::sqrt(worst.chord[i]))},
          worst.predicted[i] / grid_.local_scale};
    }
  }

 private:
  const Grid& grid_;
  std::unique_ptr<LeafPoints> points_;
};

/// The place in triangle 2 3 0 with these weights. A place outside is NaN: then the loop finds no
/// height of the triangle above the surface.
dvec2 place_of(const dvec3& weights) {
  if (!(std::min({weights.x, weights.y, weights.z}) >= 0)) return dvec2(kNan);
  return {weights.x, 1 - weights.z};
}

/// Calls f(begin, end) for parts of at most `length` of [0, count).
template <class Function>
void for_parts(std::size_t count, std::size_t length, Function f) {
  for (std::size_t begin = 0; begin < count; begin += length) {
    f(begin, std::min(begin + length, count));
  }
}

/// Validates leaves batch by batch, with columns that are computed together, and in each batch
/// block by block. `uv`: the parameters of place s of a leaf; `corners`: a leaf's corners; `place`:
/// sets its places in the columns, by its number there.
struct BatchedLoops {
  const Surface& surface;
  const Grid& grid;
  unsigned threads;

  template <class Item, class Uv, class Corners, class Place>
  std::vector<std::optional<LeafError>> measure(std::span<const Item> leaves, std::size_t places,
                                                Uv uv, Corners corners, Place place) const {
    std::vector<std::optional<LeafError>> result(leaves.size());
    Block block(surface, grid);
    for_parts(leaves.size(), kBatch, [&](std::size_t first, std::size_t last) {
      const auto batch = leaves.subspan(first, last - first);
      Columns columns(surface, batch.size(), places, threads,
                      [&](std::size_t s, std::size_t i) { return uv(s, batch[i]); });
      for_parts(batch.size(), kLeafBlock, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          block.put_corners(i - begin, corners(batch[i]));
          place(batch[i], i, columns);
        }
        block.measure(columns, begin, places,
                      std::span(result).subspan(first + begin, end - begin));
      });
    });
    return result;
  }
};

}  // namespace

std::vector<std::optional<LeafError>> validate_many(const Surface& surface, const Grid& grid,
                                                    std::span<const TwoTriangles> leaves,
                                                    unsigned threads) {
  const auto uv = [](std::size_t s, const TwoTriangles& leaf) {
    const dvec2& part = leaf.places[s];
    return leaf.low * (1.0 - part) + leaf.high * part;
  };
  const auto corners = [&](const TwoTriangles& leaf) { return corners_of(leaf, grid.mirrored); };
  const auto place = [&](const TwoTriangles& leaf, std::size_t i, Columns& columns) {
    const bool turned = grid.mesh.uv[corners(leaf)[0]] != leaf.low;
    for (std::size_t s = 0; s < leaf.places.size(); ++s) {
      columns.set_place(s, i, leaf.places[s], turned);
    }
  };
  return BatchedLoops{surface, grid, threads}.measure(leaves, std::tuple_size_v<PlacesInLeaf>, uv,
                                                      corners, place);
}

std::vector<std::optional<LeafError>> validate_places(const Surface& surface, const Grid& grid,
                                                      std::span<const PlaceOnTriangle> places,
                                                      unsigned threads) {
  const auto uv = [](std::size_t, const PlaceOnTriangle& place) { return place.uv; };
  const auto corners = [](const PlaceOnTriangle& place) { return place.corners; };
  const auto place = [](const PlaceOnTriangle& at, std::size_t i, Columns& columns) {
    columns.set_place(0, i, place_of(at.weights), false);
  };
  return BatchedLoops{surface, grid, threads}.measure(places, 1, uv, corners, place);
}

}  // namespace saddle
