#include "mesh/mesher/grid_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/random.h"
#include "mesh/error/measure_grid.h"
#include "mesh/grid/cut_grid.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/mesher/report_errors.h"
#include "mesh/model/clip.h"
#include "mesh/model/tidy.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Indices of the mesh lines nearest to `lines` evenly spaced lines, each once.
std::vector<std::size_t> nearest_mesh_lines(int lines, std::size_t cells) {
  std::vector<std::size_t> indices;
  for (int k = 0; k < lines; ++k) {
    const double part = lines > 1 ? static_cast<double>(k) / (lines - 1) : 0;
    const auto index = static_cast<std::size_t>(std::lround(part * static_cast<double>(cells)));
    if (indices.empty() || indices.back() != index) indices.push_back(index);
  }
  return indices;
}

/// Larger grids are not searched: that would take longer than to make them.
constexpr std::size_t kMostTriangles = 131'072;

/// Ends of `count` stretches of about as many cells each.
std::vector<std::size_t> stretches(std::size_t cells) {
  const std::size_t count = std::min(cells, kDomainParts);
  std::vector<std::size_t> ends;
  for (std::size_t k = 0; k <= count; ++k) ends.push_back(k * cells / count);
  return ends;
}

/// The blocks, and their triangles, which they refer to.
std::vector<SearchedPart> blocks_of(const Grid& grid, std::vector<Triangle>& triangles) {
  const std::vector<std::size_t> columns = stretches(grid.cells_u);
  const std::vector<std::size_t> rows = stretches(grid.cells_v);
  std::vector<SearchedPart> blocks;
  std::vector<std::size_t> counts;
  for (std::size_t row = 0; row + 1 < rows.size(); ++row) {
    for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
      SearchedPart block;
      const std::size_t first = grid.vertex(columns[column], rows[row]);
      const std::size_t last = grid.vertex(columns[column + 1], rows[row + 1]);
      block.box = {grid.uv(first), grid.uv(last)};
      for (std::size_t j = rows[row]; j <= rows[row + 1]; ++j) {
        for (std::size_t i = columns[column]; i <= columns[column + 1]; ++i)
          block.around.add(grid.mesh.position[grid.vertex(i, j)]);
      }
      const std::size_t before = triangles.size();
      for (std::size_t j = rows[row]; j < rows[row + 1]; ++j) {
        for (std::size_t i = columns[column]; i < columns[column + 1]; ++i) {
          const auto own = grid.triangles(grid.cell(i, j));
          triangles.insert(triangles.end(), own.begin(), own.end());
        }
      }
      counts.push_back(triangles.size() - before);
      blocks.push_back(std::move(block));
    }
  }
  std::span<const Triangle> rest = triangles;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    blocks[k].triangles = rest.first(counts[k]);
    rest = rest.subspan(counts[k]);
  }
  return blocks;
}

/// A random place in each block.
std::vector<SearchedLeaf> with_places(std::span<const SearchedPart> blocks) {
  std::vector<SearchedLeaf> sampled;
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const dvec2 part(random_unit(2 * k), random_unit(2 * k + 1));
    sampled.push_back({std::numeric_limits<double>::infinity(),  // none is skipped
                       blocks[k],
                       {glm::mix(blocks[k].box.low, blocks[k].box.high, part)}});
  }
  return sampled;
}

/// The largest distance that a search finds, if it exceeds `known`: at a random place of each of
/// up to 64 x 64 blocks of cells, and where bounds leave most room for a spike between samples. For
/// a surface of second order whose bounds are continuous.
double search_grid_error(const Surface& surface, const Grid& grid, double known, unsigned threads) {
  if (2 * grid.cell_count() > kMostTriangles) return known;
  std::vector<Triangle> triangles;
  const std::vector<SearchedPart> blocks = blocks_of(grid, triangles);
  std::vector<SearchedLeaf> sampled = with_places(blocks);
  const std::optional<Bounds> no_box;
  const WholeMeshError whole(surface, grid, triangles, no_box, threads);
  const auto measured = [&]() -> const WholeMeshError& { return whole; };
  KnownHulls hulls(surface);
  const PlacedError found = largest_error(surface, sampled, blocks, known, no_box, threads, hulls,
                                          measured, SearchFrom::Surface);
  return std::max(known, found.distance);
}

}  // namespace

MeshResult mesh_on_grid(const Surface& surface, const GridOptions& options) {
  MeshResult result;
  MeshReport& report = result.report;
  const Domain& d = surface.domain;
  Grid grid = sample_grid(
      surface, even_lines(d.u0, d.u1, static_cast<std::size_t>(options.cells_u)),
      even_lines(d.v0, d.v1, static_cast<std::size_t>(options.cells_v)), options.threads);
  require_defined_cells(grid);
  report.cells = grid.cell_count() - grid.left_out_count;
  report.undefined_fraction =
      static_cast<double>(grid.left_out_count) / static_cast<double>(grid.cell_count());
  const std::vector<std::size_t> opened = cut_grid(surface, options.threads, grid, report);

  const MeasuredError error = measure_error(surface, grid, opened, options.threads);
  report.max_error = options.is_searched
                         ? search_grid_error(surface, grid, error.distance, options.threads)
                         : error.distance;
  report.max_normal_error = error.normal_degrees;

  const bool plain = opened.empty() && grid.left_out_count == 0;
  result.mesh =
      finish_grid(std::move(grid), plain, nearest_mesh_lines(options.lines_u, grid.cells_u),
                  nearest_mesh_lines(options.lines_v, grid.cells_v));
  return result;
}

MeshResult mesh_uniformly(const Surface& surface, const UniformRequest& request) {
  const std::size_t before = surface.evaluations();
  GridOptions grid = request.grid;
  MeshResult result = mesh_on_grid(surface, grid);
  while (request.share &&
         result.report.max_error > *request.share * result.mesh.bounds.diagonal() &&
         2 * std::max(grid.cells_u, grid.cells_v) <= kMostGridCells) {
    grid.cells_u *= 2;
    grid.cells_v *= 2;
    result = mesh_on_grid(surface, grid);
  }
  if (request.clip) {
    clip_mesh(*request.clip, result.mesh);
    result.report.is_clipped = true;
    keep_used_corners(result.mesh);
  }
  if (request.share) result.report.tolerance = *request.share * result.mesh.bounds.diagonal();
  result.report.evaluations = surface.evaluations() - before;
  return result;
}

}  // namespace saddle
