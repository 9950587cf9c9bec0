#include "mesh/grid.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "base/parallel.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Corners are numbered in 32 bits, and a vertex has at most four.
constexpr std::size_t kMaxCells = std::size_t{1} << 29;
constexpr std::size_t kVertexChunk = 4096;

bool is_finite(const dvec3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// Evenly spaced, both ends exact. Weighting the ends, rather than stepping from the first, makes
/// symmetric ranges symmetric to the last bit and hits 0 where it is a grid line.
std::vector<double> grid_parameters(double first, double last, std::size_t cells) {
  std::vector<double> values(cells + 1);
  const auto n = static_cast<double>(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    const auto k = static_cast<double>(i);
    const double value = (first * (n - k) + last * k) / n;
    values[i] = std::isfinite(value) ? value : std::lerp(first, last, k / n);
  }
  values.front() = first;
  values.back() = last;
  return values;
}

void require_countable(const GridOptions& options) {
  const auto cells_u = static_cast<std::size_t>(options.cells_u);
  const auto cells_v = static_cast<std::size_t>(options.cells_v);
  if (cells_u <= kMaxCells / cells_v) return;
  throw Error(Status::Input,
              "a grid of " + std::to_string(cells_u) + " x " + std::to_string(cells_v) +
                  " cells is too large",
              {}, "at most " + std::to_string(kMaxCells) + " cells");
}

void measure_tangents(Grid& grid, unsigned threads) {
  grid.tangent_lengths.resize(grid.points.size());
  const auto length = [](const dvec3& tangent) {
    const double value = safe_length(tangent);
    return std::isfinite(value) ? value : 0;
  };
  parallel_chunks(grid.points.size(), kVertexChunk, threads,
                  [&](std::size_t begin, std::size_t end) {
                    for (std::size_t k = begin; k < end; ++k) {
                      const SurfacePoint& point = grid.points[k];
                      grid.tangent_lengths[k] = {length(point.r_u), length(point.r_v)};
                    }
                  });
}

void keep_defined_cells(Grid& grid) {
  std::vector<std::uint8_t> defined(grid.points.size());
  std::transform(grid.points.begin(), grid.points.end(), defined.begin(),
                 [](const SurfacePoint& point) { return is_finite(point.position); });
  grid.cell_kept.resize(grid.cell_count());
  grid.vertex_used.resize(grid.points.size());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    const auto vertices = grid.vertices(cell);
    if (!std::all_of(vertices.begin(), vertices.end(), [&](auto k) { return defined[k] != 0; })) {
      continue;
    }
    grid.cell_kept[cell] = 1;
    ++grid.kept_count;
    for (const std::size_t vertex : vertices) grid.vertex_used[vertex] = 1;
  }
  if (grid.kept_count > 0) return;

  const auto samples = static_cast<std::size_t>(std::count(defined.begin(), defined.end(), 1));
  const std::string all = std::to_string(defined.size());
  if (samples == 0) {
    throw Error(Status::Nothing, "the surface is undefined everywhere", {},
                "none of the " + all + " samples has finite x, y and z");
  }
  throw Error(Status::Nothing, "the surface is defined at isolated samples only", {},
              std::to_string(samples) + " of " + all +
                  " samples are finite, but no four around a cell; --samples takes more");
}

std::string format_point(const dvec3& p) {
  const auto number = [](double x) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.6g", x);
    return std::string(text.data());
  };
  return "(" + number(p.x) + ", " + number(p.y) + ", " + number(p.z) + ")";
}

void measure_extent(Grid& grid) {
  Bounds bounds;
  for (std::size_t vertex = 0; vertex < grid.points.size(); ++vertex) {
    if (grid.vertex_used[vertex]) bounds.add(grid.points[vertex].position);
  }
  const double diagonal = safe_length(bounds.size());
  if (!std::isfinite(diagonal)) {
    throw Error(Status::Nothing, "the surface has no finite extent", {},
                "its finite samples reach from " + format_point(bounds.low) + " to " +
                    format_point(bounds.high));
  }
  const dvec3 least = rounding(glm::max(glm::abs(bounds.low), glm::abs(bounds.high)));
  const bool is_point = glm::all(glm::lessThanEqual(bounds.size(), least));
  if (is_point || diagonal < std::numeric_limits<double>::min()) {
    throw Error(Status::Nothing, "the surface is a single point, " + format_point(bounds.low), {},
                "x, y and z are the same at all samples");
  }
  grid.local_scale = std::ldexp(1.0, -std::ilogb(diagonal));
  grid.diagonal = grid.local_scale * diagonal;
}

}  // namespace

dvec2 Grid::cell_centre(std::size_t cell) const {
  const std::size_t i = cell % cells_u;
  const std::size_t j = cell / cells_u;
  return {0.5 * u[i] + 0.5 * u[i + 1], 0.5 * v[j] + 0.5 * v[j + 1]};
}

std::array<std::size_t, 4> Grid::vertices(std::size_t cell) const {
  const std::size_t first = cell + cell / cells_u;  // a row has one vertex more than cells
  const std::size_t above = first + cells_u + 1;
  return {first, first + 1, above + 1, above};
}

dvec2 Grid::tangent_scale(std::size_t vertex) const {
  const std::size_t i = vertex % (cells_u + 1);
  const std::size_t j = vertex / (cells_u + 1);
  dvec2 scale(0);
  for (std::size_t b = j - (j > 0); b <= std::min(j + 1, cells_v); ++b) {
    for (std::size_t a = i - (i > 0); a <= std::min(i + 1, cells_u); ++a) {
      scale = glm::max(scale, tangent_lengths[b * (cells_u + 1) + a]);
    }
  }
  return scale;
}

Grid sample_grid(const Surface& surface, const GridOptions& options) {
  require_countable(options);
  const Domain& domain = surface.domain;
  Grid grid;
  grid.cells_u = static_cast<std::size_t>(options.cells_u);
  grid.cells_v = static_cast<std::size_t>(options.cells_v);
  grid.u = grid_parameters(domain.u0, domain.u1, grid.cells_u);
  grid.v = grid_parameters(domain.v0, domain.v1, grid.cells_v);
  grid.mirrored = runs_backwards(domain) != surface.flip;
  grid.points = evaluate_on_grid(surface, grid.u, grid.v, options.threads);
  keep_defined_cells(grid);
  measure_extent(grid);
  measure_tangents(grid, options.threads);
  return grid;
}

}  // namespace saddle
