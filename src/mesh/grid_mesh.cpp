#include "mesh/grid_mesh.h"

#include <algorithm>
#include <memory>
#include <span>

#include "base/error.h"
#include "mesh/corners.h"
#include "mesh/degenerate.h"
#include "mesh/grid.h"
#include "mesh/lines.h"
#include "mesh/measure.h"
#include "mesh/triangulate.h"
#include "mesh/weld.h"

namespace saddle {

namespace {

constexpr std::uint32_t kNone = 0xffffffff;

/// The triangles without the gaps that cells with fewer than two leave.
void close_gaps(Grid& grid) {
  std::size_t count = 0;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (const Triangle& triangle : grid.triangles(cell)) grid.mesh.triangles[count++] = triangle;
  }
  grid.mesh.triangles.resize(count);
}

/// For each vertex a corner that triangles use: its own, or one of the same point where a pole's
/// triangles use only their neighbours' corners.
std::vector<std::uint32_t> corners_for_lines(const Grid& grid, std::span<const bool> used) {
  const auto& point = grid.mesh.point;
  std::vector<std::uint32_t> of_point(grid.vertex_count(), kNone);
  for (std::uint32_t corner = 0; corner < point.size(); ++corner) {
    if (used[corner]) of_point[point[corner]] = corner;
  }
  std::vector<std::uint32_t> corners(grid.vertex_count());
  for (std::uint32_t vertex = 0; vertex < corners.size(); ++vertex) {
    corners[vertex] = used[vertex] ? vertex : of_point[point[vertex]];
  }
  return corners;
}

/// Gives the points of the mesh, which are named after their first vertices, numbers without gaps.
void number_points(Grid& grid) {
  Mesh& mesh = grid.mesh;
  std::vector<std::uint32_t> numbers(grid.vertex_count(), kNone);
  for (std::uint32_t& point : mesh.point) {
    std::uint32_t& number = numbers[point];
    if (number == kNone) number = mesh.point_count++;
    point = number;
  }
}

/// Leaves out the corners that no triangle uses; triangles and lines follow.
void drop_unused_corners(Mesh& mesh, std::span<const bool> used) {
  std::vector<std::uint32_t> numbers(used.size());
  std::uint32_t count = 0;
  mesh.bounds = Bounds();
  for (std::size_t corner = 0; corner < used.size(); ++corner) {
    if (!used[corner]) continue;
    mesh.bounds.add(mesh.position[corner]);
    mesh.position[count] = mesh.position[corner];
    mesh.normal[count] = mesh.normal[corner];
    mesh.uv[count] = mesh.uv[corner];
    mesh.point[count] = mesh.point[corner];
    numbers[corner] = count++;
  }
  mesh.position.resize(count);
  mesh.normal.resize(count);
  mesh.uv.resize(count);
  mesh.point.resize(count);
  for (Triangle& triangle : mesh.triangles) {
    for (std::uint32_t& corner : triangle) corner = numbers[corner];
  }
  for (std::vector<std::uint32_t>& line : mesh.lines) {
    for (std::uint32_t& corner : line) corner = numbers[corner];
  }
}

/// Makes lines and the final arrays of a grid whose cells are all cut.
void finish(Grid& grid, const GridOptions& options, bool all_plain) {
  Mesh& mesh = grid.mesh;
  if (all_plain) {  // every vertex is a corner, every place for a triangle holds one
    mesh.lines = grid_lines(grid, {}, options);
    number_points(grid);
    return;
  }
  const auto used = std::make_unique<bool[]>(mesh.position.size());
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    for (const Triangle& triangle : grid.triangles(cell)) {
      for (const std::uint32_t corner : triangle) used[corner] = true;
    }
  }
  const std::span<const bool> used_corners(used.get(), mesh.position.size());
  mesh.lines = grid_lines(grid, corners_for_lines(grid, used_corners), options);
  close_gaps(grid);
  drop_unused_corners(mesh, used_corners);
  number_points(grid);
}

void require_triangles(const Grid& grid) {
  const auto has_triangle = [](Cell cell) { return cell == Cell::One || cell == Cell::Two; };
  if (std::ranges::any_of(grid.cells, has_triangle)) return;
  throw Error(Status::Nothing, "no cell of the grid has any area", {},
              "the surface repeats itself in step with the " + std::to_string(grid.cells_u) +
                  " x " + std::to_string(grid.cells_v) + " cells; --samples takes more");
}

}  // namespace

GridMesh mesh_on_grid(const Surface& surface, const GridOptions& options) {
  GridMesh result;
  MeshReport& report = result.report;
  Grid grid = sample_grid(surface, options);
  report.cells = grid.cell_count() - grid.left_out_count;
  report.evaluations = grid.vertex_count();
  report.undefined_fraction =
      static_cast<double>(grid.left_out_count) / static_cast<double>(grid.cell_count());

  require_two_dimensional(surface, grid, options.threads);
  const Seams seams = weld(grid);
  report.closed_u = seams.closed_u;
  report.closed_v = seams.closed_v;
  const std::vector<OpenCell> open = open_cells(surface, options.threads, grid, report);
  triangulate(grid, open);
  require_triangles(grid);
  std::vector<std::size_t> opened;
  for (const OpenCell& cell : open) {
    report.flat_triangles += 2 - grid.triangle_count(cell.cell);
    opened.push_back(cell.cell);
  }

  const MeasuredError error = measure_error(surface, grid, opened, options.threads);
  report.max_error = error.distance;
  report.max_normal_error = error.normal_degrees;
  report.evaluations += error.evaluations;

  finish(grid, options, open.empty() && grid.left_out_count == 0);
  result.mesh = std::move(grid.mesh);
  return result;
}

}  // namespace saddle
