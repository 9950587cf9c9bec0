#include "mesh/grid/irregular.h"

#include <algorithm>
#include <cmath>

#include "base/parallel.h"
#include "mesh/features/singular.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Vertices that are not regular.
struct Irregular {
  std::vector<std::size_t> undefined;
  std::vector<std::size_t> singular;
  /// Vertices beside much longer tangents that may be regular, and their normals if they are.
  std::vector<std::size_t> doubtful;
  std::vector<dvec3> normals;
};

/// Vertices [column, end_column) x [row, end_row).
struct Window {
  std::size_t column, end_column;
  std::size_t row, end_row;

  std::size_t columns() const { return end_column - column; }
  std::size_t rows() const { return end_row - row; }
};

/// The lengths of tangents around each vertex of a window, from the vertices in the window and
/// beside it.
class Neighbourhood {
 public:
  Neighbourhood(const Surface& surface, const Grid& grid, const Window& inner)
      : outer_{inner.column - (inner.column > 0 ? 1 : 0),
               std::min(inner.end_column + 1, grid.u.size()), inner.row - (inner.row > 0 ? 1 : 0),
               std::min(inner.end_row + 1, grid.v.size())},
        points_(evaluate_on_grid(surface,
                                 std::span(grid.u).subspan(outer_.column, outer_.columns()),
                                 std::span(grid.v).subspan(outer_.row, outer_.rows()), 1)) {
    const auto length = [](const dvec3& tangent) {
      const double value = safe_length(tangent);
      return std::isfinite(value) ? value : 0;
    };
    lengths_.reserve(points_.size());
    for (const SurfacePoint& p : points_) lengths_.emplace_back(length(p.r_u), length(p.r_v));
  }

  /// The largest terms of r_u x r_v among the vertex and its neighbours.
  double terms(std::size_t i, std::size_t j) const {
    double largest = 0;
    for_around(i, j, [&](std::size_t k) {
      const double terms = cross_terms(points_[k]);
      if (std::isfinite(terms)) largest = std::max(largest, terms);
    });
    return largest;
  }

  const SurfacePoint& point(std::size_t i, std::size_t j) const { return points_[index(i, j)]; }

  /// The largest |r_u| and |r_v| among the vertex and its neighbours.
  dvec2 scale(std::size_t i, std::size_t j) const {
    dvec2 result(0);
    for_around(i, j, [&](std::size_t k) { result = glm::max(result, lengths_[k]); });
    return result;
  }

 private:
  /// Calls f(index) for the vertex and its neighbours.
  template <class F>
  void for_around(std::size_t i, std::size_t j, F f) const {
    for (std::size_t b = std::max(j, outer_.row + 1) - 1; b < std::min(j + 2, outer_.end_row);
         ++b) {
      for (std::size_t a = std::max(i, outer_.column + 1) - 1;
           a < std::min(i + 2, outer_.end_column); ++a) {
        f(index(a, b));
      }
    }
  }

  std::size_t index(std::size_t i, std::size_t j) const {
    return (j - outer_.row) * outer_.columns() + (i - outer_.column);
  }

  Window outer_;
  std::vector<SurfacePoint> points_;
  std::vector<dvec2> lengths_;
};

/// The summaries of a grid's rows, tile beside tile.
class Summaries {
 public:
  Summaries(const GridTiling& tiling, std::span<const TileSummary> tiles, const Grid& grid)
      : tiling_(tiling), tiles_(tiles), last_row_(grid.cells_v) {}

  /// Whether the summaries prove every vertex of a tile's row regular, by the least cross product
  /// and the largest tangents in the rows and tiles around.
  bool is_regular(std::size_t across, std::size_t row) const {
    const RowSummary& own = at(across, row);
    if (!own.finite) return false;
    double uu = 0;
    double vv = 0;
    const std::size_t first = row - (row > 0 ? 1 : 0);
    for (std::size_t j = first; j <= std::min(row + 1, last_row_); ++j) {
      for (std::size_t a = across - (across > 0 ? 1 : 0);
           a <= std::min(across + 1, tiling_.across() - 1); ++a) {
        const RowSummary& near = at(a, j);
        if (!near.finite) return false;
        uu = std::max(uu, near.largest_uu);
        vv = std::max(vv, near.largest_vv);
      }
    }
    return own.least_cross > kDegenerateCross * std::sqrt(uu) * std::sqrt(vv);
  }

 private:
  const RowSummary& at(std::size_t across, std::size_t row) const {
    const std::size_t down = std::min(row, last_row_ - 1) / kTileCells;
    return tiles_[down * tiling_.across() + across].rows[row - down * kTileCells];
  }

  const GridTiling& tiling_;
  std::span<const TileSummary> tiles_;
  std::size_t last_row_;
};

/// Classifies each vertex of a window.
Irregular inspect(const Surface& surface, const Window& window, Grid& grid) {
  Irregular found;
  const Neighbourhood around(surface, grid, window);
  for (std::size_t j = window.row; j < window.end_row; ++j) {
    for (std::size_t i = window.column; i < window.end_column; ++i) {
      const std::size_t vertex = grid.vertex(i, j);
      if (!is_finite(grid.mesh.position[vertex])) {
        found.undefined.push_back(vertex);
        continue;
      }
      const dvec2 scale = around.scale(i, j);
      const auto normal = unit_normal(around.point(i, j), scale.x, scale.y, surface.flip);
      if (normal) {
        grid.mesh.normal[vertex] = *normal;
        continue;
      }
      const SurfacePoint& point = around.point(i, j);
      const auto known = known_normal(point, surface.flip);
      const double size = safe_length(glm::cross(point.r_u, point.r_v));
      if (known && size > kRoundingOfSums * around.terms(i, j)) {
        found.doubtful.push_back(vertex);
        found.normals.push_back(*known);
      } else {
        found.singular.push_back(vertex);
      }
    }
  }
  return found;
}

/// Decides which of the doubtful vertices are singular.
void settle_doubtful(const Surface& surface, unsigned threads, Irregular& found, Grid& grid) {
  std::vector<dvec2> uv;
  for (const std::size_t vertex : found.doubtful) uv.push_back(grid.uv(vertex));
  const std::vector<bool> are = are_singular(surface, uv, threads);
  for (std::size_t k = 0; k < uv.size(); ++k) {
    if (are[k]) {
      found.singular.push_back(found.doubtful[k]);
    } else {
      grid.mesh.normal[found.doubtful[k]] = found.normals[k];
    }
  }
}

/// The windows of a column of tiles that may have irregular vertices: runs of rows.
std::vector<Window> windows(const Summaries& summaries, const Grid& grid, std::size_t across) {
  std::vector<Window> result;
  const std::size_t column = across * kTileCells;
  const bool last = column + kTileCells >= grid.cells_u;
  const std::size_t end_column = last ? grid.u.size() : column + kTileCells;
  for (std::size_t row = 0; row < grid.v.size(); ++row) {
    if (summaries.is_regular(across, row)) continue;
    const bool extends =
        !result.empty() && result.back().end_row == row && result.back().rows() < kTileCells;
    if (!extends) result.push_back({column, end_column, row, row});
    result.back().end_row = row + 1;
  }
  return result;
}

}  // namespace

void find_irregular(const Surface& surface, const GridTiling& tiling,
                    std::span<const TileSummary> tiles, unsigned threads, Grid& grid) {
  const Summaries summaries(tiling, tiles, grid);
  std::vector<Window> all;
  for (std::size_t across = 0; across < tiling.across(); ++across) {
    const std::vector<Window> column = windows(summaries, grid, across);
    all.insert(all.end(), column.begin(), column.end());
  }
  std::vector<Irregular> found(all.size());
  parallel_chunks(all.size(), 1, threads,
                  [&](std::size_t k, std::size_t) { found[k] = inspect(surface, all[k], grid); });

  for (Irregular& part : found) settle_doubtful(surface, threads, part, grid);
  for (const Irregular& part : found) {
    for (const std::size_t vertex : part.undefined) {
      grid.for_cells_around(vertex, [&grid](std::size_t cell, std::size_t) {
        grid.cells[cell] = GridCell::LeftOut;
        ++grid.left_out_count;
      });
    }
  }
  for (const Irregular& part : found) {
    for (const std::size_t vertex : part.singular) {
      if (!grid.is_used(vertex)) continue;
      grid.open_around(vertex);
      grid.singular.push_back(vertex);
    }
  }
  std::sort(grid.singular.begin(), grid.singular.end());
}

}  // namespace saddle
