#include "mesh/cut_grid.h"

#include <algorithm>
#include <string>

#include "base/error.h"
#include "mesh/corners.h"
#include "mesh/degenerate.h"
#include "mesh/lines.h"
#include "mesh/tidy.h"
#include "mesh/triangulate.h"

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

std::vector<std::size_t> cut_grid(const Surface& surface, unsigned threads, Grid& grid,
                                  MeshReport& report) {
  require_two_dimensional(surface, grid, threads);
  const Seams seams = weld(grid);
  report.closed_u = seams.u.name();
  report.closed_v = seams.v.name();
  const std::vector<OpenCell> open = open_cells(surface, threads, grid, report);
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
  return opened;
}

Mesh finish_grid(Grid&& grid, bool plain, const std::vector<std::size_t>& columns,
                 const std::vector<std::size_t>& rows) {
  grid.mesh.lines = grid_lines(grid, columns, rows);
  if (plain) {
    number_points(grid.mesh);  // every vertex is a corner, every place for a triangle holds one
  } else {
    close_gaps(grid);
    keep_used_corners(grid.mesh);
  }
  return std::move(grid.mesh);
}

}  // namespace saddle
