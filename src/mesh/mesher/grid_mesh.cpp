#include "mesh/mesher/grid_mesh.h"

#include <cmath>

#include "mesh/error/sampled_error.h"
#include "mesh/grid/cut_grid.h"
#include "mesh/grid/grid.h"
#include "mesh/grid/sample_grid.h"
#include "mesh/model/parameter_box.h"

namespace saddle {

namespace {

/// Indices of the mesh lines nearest to `lines` evenly spaced ones, without repetition.
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
  report.evaluations = grid.vertex_count();
  report.undefined_fraction =
      static_cast<double>(grid.left_out_count) / static_cast<double>(grid.cell_count());
  const std::vector<std::size_t> opened = cut_grid(surface, options.threads, grid, report);

  const MeasuredError error = measure_error(surface, grid, opened, options.threads);
  report.max_error = error.distance;
  report.max_normal_error = error.normal_degrees;
  report.evaluations += error.evaluations;

  const bool plain = opened.empty() && grid.left_out_count == 0;
  result.mesh =
      finish_grid(std::move(grid), plain, nearest_mesh_lines(options.lines_u, grid.cells_u),
                  nearest_mesh_lines(options.lines_v, grid.cells_v));
  return result;
}

}  // namespace saddle
