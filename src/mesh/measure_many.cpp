#include "mesh/measure_many.h"

#include <algorithm>
#include <cmath>
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
  Columns(const Surface& surface, std::span<const TwoTriangles> leaves, unsigned threads)
      : stride_(leaves.size()), p_(kPlacesInLeaf * stride_), q_(p_.size()) {
    Array<double> u(p_.size());
    Array<double> v(p_.size());
    for (std::size_t s = 0; s < kPlacesInLeaf; ++s) {
      for (std::size_t i = 0; i < stride_; ++i) {
        const TwoTriangles& leaf = leaves[i];
        const dvec2& part = leaf.places[s];
        const dvec2 uv = leaf.low * (1.0 - part) + leaf.high * part;
        u[s * stride_ + i] = uv.x;
        v[s * stride_ + i] = uv.y;
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

/// Leaves of a batch, of which `begin` is the number of the first.
void measure_block(const Grid& grid, std::span<const TwoTriangles> leaves, std::size_t begin,
                   Columns& columns, LeafPoints& points,
                   std::span<std::optional<Deviation>> result) {
  const std::size_t count = leaves.size();
  for (std::size_t i = 0; i < count; ++i) {
    const TwoTriangles& leaf = leaves[i];
    const auto corners = corners_of(leaf, grid.mirrored);
    for (std::size_t k = 0; k < 4; ++k) {
      put_vertex(grid.local(corners[k]), grid.mesh.normal[corners[k]], i, points.corner[k]);
    }
    const bool turned = grid.mesh.uv[corners[0]] != leaf.low;
    for (std::size_t s = 0; s < kPlacesInLeaf; ++s) {
      columns.set_place(s, begin + i, leaf.places[s], turned);
    }
  }
  LeafDeviations worst;
  std::fill_n(worst.distance.begin(), count, 0.0);
  std::fill_n(worst.chord.begin(), count, 0.0);
  std::fill_n(worst.is_known.begin(), count, 1.0);
  const MeasureLeaves loop = measure_loop(cpu_level());
  for (std::size_t s = 0; s < kPlacesInLeaf; ++s) {
    loop(points, columns.places(s, begin), count, worst);
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!(worst.is_known[i] > 0)) continue;
    result[i] = {worst.distance[i] / grid.local_scale, degrees_of_chord(std::sqrt(worst.chord[i]))};
  }
}

}  // namespace

std::vector<std::optional<Deviation>> measure_many(const Surface& surface, const Grid& grid,
                                                   std::span<const TwoTriangles> leaves,
                                                   unsigned threads) {
  std::vector<std::optional<Deviation>> result(leaves.size());
  const auto points = std::make_unique_for_overwrite<LeafPoints>();
  points->scale = grid.local_scale;
  points->front = surface.flip ? -1 : 1;
  for (std::size_t first = 0; first < leaves.size(); first += kBatch) {
    const auto batch = leaves.subspan(first, std::min(kBatch, leaves.size() - first));
    Columns columns(surface, batch, threads);
    for (std::size_t begin = 0; begin < batch.size(); begin += kLeafBlock) {
      const std::size_t count = std::min(kLeafBlock, batch.size() - begin);
      measure_block(grid, batch.subspan(begin, count), begin, columns, *points,
                    std::span(result).subspan(first + begin, count));
    }
  }
  return result;
}

}  // namespace saddle
