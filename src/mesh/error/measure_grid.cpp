#include "mesh/error/measure_grid.h"

#include <algorithm>
#include <array>
#include <vector>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "base/random.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/grid/triangulate.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Cells that are measured at most, at three points each: a sixth of the points of a default grid.
constexpr std::size_t kMostMeasuredCells = 2048;
/// Places in a cell where an error is largest: its middle and the middles of two edges (the other
/// two belong to the neighbours).
constexpr std::array<dvec2, 3> kWorstPlaces = {dvec2(0.5, 0.5), dvec2(0.5, 0), dvec2(0, 0.5)};

class GridMeasurement {
 public:
  GridMeasurement(const Surface& surface, const Grid& grid, std::span<const std::size_t> opened,
                  unsigned threads)
      : surface_(surface), grid_(grid), opened_(opened), threads_(threads) {}

  MeasuredError measure() const {
    const std::vector<std::size_t> cells = choose_cells();
    std::vector<dvec2> uv;
    uv.reserve(cells.size() * kWorstPlaces.size());
    for (const std::size_t cell : cells) append_places(cell, uv);
    const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);

    std::vector<SampledError> errors(points.size());
    parallel_chunks(points.size(), kInBatch, threads_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k) {
        const std::size_t cell = cells[k / kWorstPlaces.size()];
        errors[k] = sampled_error(grid_, grid_.triangles(cell), uv[k], points[k], surface_.flip);
      }
    });
    MeasuredError largest{0, 0, points.size()};
    for (const SampledError& e : errors) {
      largest.distance = std::max(largest.distance, e.distance);
      largest.normal_degrees = std::max(largest.normal_degrees, e.degrees);
    }
    return largest;
  }

 private:
  /// The largest sagitta of the edges of a cell's triangles.
  double estimate(std::size_t cell) const {
    double largest = 0;
    for (const Triangle& t : grid_.triangles(cell)) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = t[k];
        const std::uint32_t b = t[(k + 1) % 3];
        const double edge =
            sagitta(mesh_.position[a], mesh_.normal[a], mesh_.position[b], mesh_.normal[b]);
        largest = std::max(largest, edge);
      }
    }
    return largest;
  }

  /// All cells with triangles, if they are few; else half of the cells spread over the domain and
  /// half with the largest sagittas.
  std::vector<std::size_t> choose_cells() const {
    if (grid_.cell_count() <= kMostMeasuredCells) return spread_cells(grid_.cell_count());
    const std::size_t half = kMostMeasuredCells / 2;
    std::vector<std::size_t> cells = spread_cells(half);
    std::vector<CellSagitta> worst = grid_.worst;
    for (const std::size_t cell : opened_) worst.push_back({cell, estimate(cell)});
    if (worst.size() > half) {
      const auto end = worst.begin() + static_cast<std::ptrdiff_t>(half);
      std::nth_element(worst.begin(), end, worst.end(),
                       [](const CellSagitta& a, const CellSagitta& b) {
                         return a.sagitta != b.sagitta ? a.sagitta > b.sagitta : a.cell < b.cell;
                       });
      worst.resize(half);
    }
    for (const CellSagitta& candidate : worst) {
      if (grid_.triangle_count(candidate.cell) > 0) cells.push_back(candidate.cell);
    }
    return cells;
  }

  /// A random cell of each of `count` equally long stretches of the grid's cells, or the next one
  /// in the stretch that has triangles.
  std::vector<std::size_t> spread_cells(std::size_t count) const {
    std::vector<std::size_t> chosen;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t begin = k * grid_.cell_count() / count;
      const std::size_t length = (k + 1) * grid_.cell_count() / count - begin;
      const auto first = static_cast<std::size_t>(random_unit(k) * static_cast<double>(length));
      for (std::size_t step = 0; step < length; ++step) {
        const std::size_t cell = begin + (first + step) % length;
        if (grid_.triangle_count(cell) == 0) continue;
        chosen.push_back(cell);
        break;
      }
    }
    return chosen;
  }

  void append_places(std::size_t cell, std::vector<dvec2>& uv) const {
    const auto vertices = grid_.vertices(cell);
    const dvec2 low = grid_.uv(vertices[0]);
    const dvec2 high = grid_.uv(vertices[2]);
    for (std::size_t k = 0; k < kWorstPlaces.size(); ++k) {
      const std::uint64_t key = 2 * (cell * kWorstPlaces.size() + k);
      const dvec2 random(random_unit(key), random_unit(key + 1));
      const dvec2 off = glm::sign(kWorstPlaces[k]) * (2.0 * random - 1.0) * kSampleJitter;
      const dvec2 part = kWorstPlaces[k] + off;
      uv.push_back(low * (1.0 - part) + high * part);
    }
  }

  const Surface& surface_;
  const Grid& grid_;
  const Mesh& mesh_ = grid_.mesh;
  std::span<const std::size_t> opened_;
  unsigned threads_;
};

}  // namespace

MeasuredError measure_error(const Surface& surface, const Grid& grid,
                            std::span<const std::size_t> opened, unsigned threads) {
  return GridMeasurement(surface, grid, opened, threads).measure();
}

}  // namespace saddle
