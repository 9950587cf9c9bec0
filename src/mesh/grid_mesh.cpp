#include "mesh/grid_mesh.h"

#include <algorithm>

#include "base/error.h"
#include "mesh/corners.h"
#include "mesh/degenerate.h"
#include "mesh/grid.h"
#include "mesh/lines.h"
#include "mesh/measure.h"
#include "mesh/tidy.h"
#include "mesh/triangulate.h"
#include "mesh/weld.h"

namespace saddle {

namespace {

/// A surface whose extents differ by more has no triangles in doubles. What sin(pi) and its like,
/// some 1e-16, and products of two leave of an extent of 0 is not meant.
constexpr double kTooThin = 1e-40;

/// The triangles without the gaps that cells with fewer than two leave.
void close_gaps(Grid& grid) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (const Triangle& triangle : grid.triangles(cell)) grid.mesh.triangles[count++] = triangle;
  }
  grid.mesh.triangles.resize(count);
}

void require_triangles(const Grid& grid) {
  const auto has_triangle = [](Cell cell) { return cell == Cell::One || cell == Cell::Two; };
  if (std::ranges::any_of(grid.cells, has_triangle)) return;
  const dvec3 size = grid.mesh.bounds.size();
  const double longest = std::max({size.x, size.y, size.z});
  const double shortest = std::min({size.x, size.y, size.z});
  if (shortest > 0 && shortest <= kTooThin * longest) {
    throw Error(
        Status::Nothing, "no cell of the grid has any area in double precision", {},
        "the surface is too long next to its width: give u and v ranges in which x, y and z "
        "stay in proportion");
  }
  throw Error(Status::Nothing, "no cell of the grid has any area", {},
              "the surface repeats itself in step with the " + std::to_string(grid.cells_u) +
                  " x " + std::to_string(grid.cells_v) + " cells; --samples takes more");
}

}  // namespace

GridMesh mesh_on_grid(const Surface& surface, const GridOptions& options) {
  GridMesh result;
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

  require_two_dimensional(surface, grid, options.threads);
  const Seams seams = weld(grid);
  report.closed_u = seams.u.name();
  report.closed_v = seams.v.name();
  const std::vector<OpenCell> open = open_cells(surface, options.threads, grid, report);
  triangulate(grid, open);
  require_triangles(grid);
  std::vector<std::size_t> opened;
  for (const OpenCell& cell : open) {
    std::vector<std::uint32_t> points;
    for (const std::uint32_t corner : cell.corners) points.push_back(grid.mesh.point[corner]);
    const std::size_t expected = triangles_between(points);
    const std::size_t count = grid.triangle_count(cell.cell);
    report.flat_triangles += expected > count ? expected - count : 0;
    opened.push_back(cell.cell);
  }

  const MeasuredError error = measure_error(surface, grid, opened, options.threads);
  report.max_error = error.distance;
  report.max_normal_error = error.normal_degrees;
  report.evaluations += error.evaluations;

  grid.mesh.lines = grid_lines(grid, options);
  if (open.empty() && grid.left_out_count == 0) {
    number_points(grid.mesh);  // every vertex is a corner, every place for a triangle holds one
  } else {
    close_gaps(grid);
    keep_used_corners(grid.mesh);
  }
  result.mesh = std::move(grid.mesh);
  return result;
}

}  // namespace saddle
