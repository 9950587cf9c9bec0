#include "surface/surface.h"

#include <algorithm>
#include <array>

#include "base/parallel.h"
#include "eval/batch.h"
#include "formula/derive.h"

namespace saddle {

namespace {

constexpr std::size_t kOutputs = 9;  // x y z, their derivatives by u, then by v
/// Points computed at a time: the nine columns of a block (1.2 MB) stay in the outer caches, and a
/// block is long enough to keep many threads busy.
constexpr std::size_t kBlock = std::size_t{1} << 14;
/// Points per chunk when columns are turned into points.
constexpr std::size_t kPackChunk = 4096;

/// The tape's outputs for one block, a column each.
class Columns {
 public:
  explicit Columns(std::size_t capacity) : values_(kOutputs * capacity) {
    for (std::size_t k = 0; k < kOutputs; ++k) starts_[k] = values_.data() + k * capacity;
  }
  std::span<double* const> outputs() const { return starts_; }

  void pack(std::span<SurfacePoint> points, unsigned threads) const {
    parallel_chunks(points.size(), kPackChunk, threads, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        points[i] = {triple(0, i), triple(3, i), triple(6, i)};
      }
    });
  }

 private:
  dvec3 triple(std::size_t first, std::size_t i) const {
    return {starts_[first][i], starts_[first + 1][i], starts_[first + 2][i]};
  }

  std::vector<double> values_;
  std::array<double*, kOutputs> starts_;
};

}  // namespace

Surface make_surface(Graph& graph, NodeId x, NodeId y, NodeId z, const Domain& domain, bool flip) {
  std::vector<NodeId> outputs = {x, y, z};
  Surface surface{domain, flip, compile(graph, outputs), {}};
  const std::vector<NodeId> by_u = derive(graph, std::array{x, y, z}, kSymbolU);
  const std::vector<NodeId> by_v = derive(graph, std::array{x, y, z}, kSymbolV);
  outputs.insert(outputs.end(), by_u.begin(), by_u.end());
  outputs.insert(outputs.end(), by_v.begin(), by_v.end());
  surface.first_order = compile(graph, outputs);
  return surface;
}

std::vector<SurfacePoint> evaluate(const Surface& surface, std::span<const dvec2> uv,
                                   unsigned threads) {
  std::vector<SurfacePoint> points(uv.size());
  const std::size_t block = std::min(kBlock, uv.size());
  const Columns columns(block);
  std::vector<double> u(block);
  std::vector<double> v(block);
  for (std::size_t begin = 0; begin < uv.size(); begin += block) {
    const std::size_t count = std::min(block, uv.size() - begin);
    for (std::size_t i = 0; i < count; ++i) {
      u[i] = uv[begin + i].x;
      v[i] = uv[begin + i].y;
    }
    evaluate_points(surface.first_order, std::span(u).first(count), std::span(v).first(count),
                    columns.outputs(), threads);
    columns.pack(std::span(points).subspan(begin, count), threads);
  }
  return points;
}

std::vector<SurfacePoint> evaluate_on_grid(const Surface& surface, std::span<const double> u,
                                           std::span<const double> v, unsigned threads) {
  std::vector<SurfacePoint> points(u.size() * v.size());
  if (points.empty()) return points;
  const std::size_t rows = std::clamp<std::size_t>(kBlock / u.size(), 1, v.size());
  const Columns columns(rows * u.size());
  for (std::size_t row = 0; row < v.size(); row += rows) {
    const std::size_t count = std::min(rows, v.size() - row);
    evaluate_grid(surface.first_order, u, v.subspan(row, count), columns.outputs(), threads);
    columns.pack(std::span(points).subspan(row * u.size(), count * u.size()), threads);
  }
  return points;
}

}  // namespace saddle
