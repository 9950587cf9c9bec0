#include "mesh/mesher/grid_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/numbers.h"
#include "mesh/error/measure_grid.h"
#include "mesh/grid/cut_grid.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/mesher/halving_limits.h"
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
  report.max_error = error.distance;
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
  const auto error_ratio = [&] {
    const double allowed =
        request.share ? *request.share * result.mesh.bounds.diagonal() : kInfinity;
    return result.report.max_error / allowed;
  };
  double ratio = error_ratio();
  std::uint8_t stagnation = 0;
  while (ratio > 1 && stagnation < kInVain && surface.may_go_on() &&
         2 * std::max(grid.cells_u, grid.cells_v) <= kMostGridCells) {
    grid.cells_u *= 2;
    grid.cells_v *= 2;
    result = mesh_on_grid(surface, grid);
    const double parent_ratio = std::exchange(ratio, error_ratio());
    stagnation = count_stagnation(stagnation, ratio, parent_ratio);
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
