#include "mesh/grid/cut_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/error.h"
#include "base/format.h"
#include "mesh/grid/corners.h"
#include "mesh/grid/degenerate.h"
#include "mesh/grid/lines.h"
#include "mesh/grid/triangulate.h"
#include "mesh/model/tidy.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// A range of at most 1000 doubles is too short for a mesh: rounding is a large part of each cell.
constexpr double kFewDoubles = 1000;

/// One cell in 1000 may have a triangle by chance where all are as thin as rounding.
constexpr std::size_t kFewCells = 1000;

/// Throws if all triangles are thinner than rounding.
[[noreturn]] void throw_too_long(int axis, double times, const Domain& domain) {
  const std::string many = std::isfinite(times) ? formatted("%.0e", times) : "countless";
  throw Error(Status::Nothing,
              "the surface is " + many + " times as long along " + "xyz"[axis] +
                  " as it is wide: in double precision it is a line",
              {},
              std::string("scale ") + "xyz"[axis] + " down, or give ranges of " + domain.names[0] +
                  " and " + domain.names[1] + " in which x, y and z stay in proportion");
}

/// Throws if a parameter's range holds only a few doubles.
void require_doubles(const std::string& name, double first, double last) {
  const double step =
      std::numeric_limits<double>::epsilon() * std::max(std::fabs(first), std::fabs(last));
  const double count = std::fabs(last - first) / step;
  if (count > kFewDoubles) return;
  const std::string text = formatted(" = %.17g and %.17g", first, last);
  throw Error(Status::Nothing, "the range of " + name + " is too short for double precision", {},
              "between " + name + text + " there are about " + std::to_string(std::lround(count)) +
                  " numbers; " + name + " = 0 is where they are closest to each other");
}

/// Closes the gaps that cells of fewer than two triangles leave.
void close_gaps(Grid& grid) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (const Triangle& triangle : grid.triangles(cell)) grid.mesh.triangles[count++] = triangle;
  }
  grid.mesh.triangles.resize(count);
}

/// The box around the vertices and some centres of cells: all vertices of a sphere of one cell are
/// on a line.
dvec3 extent(const Surface& surface, const Grid& grid, unsigned threads) {
  std::vector<dvec2> centres;
  const std::size_t stride = grid.cell_count() / kStandForAll + 1;
  for (std::size_t cell = 0; cell < grid.cell_count(); cell += stride) {
    centres.push_back(grid.cell_centre(cell));
  }
  Bounds bounds = grid.mesh.bounds;
  for (const SurfacePoint& point : evaluate(surface, centres, threads)) {
    if (is_finite(point.position)) bounds.add(point.position);
  }
  return bounds.size();
}

void require_triangles(const Surface& surface, const Grid& grid, unsigned threads) {
  const auto has_triangle = [](GridCell cell) {
    return cell == GridCell::One || cell == GridCell::Two;
  };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(grid.cells, has_triangle));
  if (count > grid.cell_count() / kFewCells) return;
  const dvec3 size = extent(surface, grid, threads);
  const int axis = size.x >= std::max(size.y, size.z) ? 0 : size.y >= size.z ? 1 : 2;
  const double width = std::max(size[(axis + 1) % 3], size[(axis + 2) % 3]);
  // It has no triangles in double precision.
  if (width > 0 && width < kRoundingOfSums * size[axis])
    throw_too_long(axis, size[axis] / width, surface.domain);
  if (count > 0) return;
  const Domain& d = surface.domain;
  require_doubles(d.names[0], d.u0, d.u1);
  require_doubles(d.names[1], d.v0, d.v1);
  throw Error(Status::Nothing, "no cell of the grid has any area", {},
              "the surface is a line in double precision, or repeats itself in step with the " +
                  std::to_string(grid.cells_u) + " x " + std::to_string(grid.cells_v) +
                  " cells; --samples takes more");
}

}  // namespace

std::vector<std::size_t> cut_grid(const Surface& surface, unsigned threads, Grid& grid,
                                  MeshReport& report) {
  require_two_dimensional(surface, grid, threads);
  report_seams(weld(surface, threads, grid), report);
  const std::vector<OpenCell> open = open_cells(surface, threads, grid, report);
  triangulate(grid, open);
  require_triangles(surface, grid, threads);
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
