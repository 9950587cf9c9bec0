#include "mesh/grid_mesh.h"

#include <algorithm>

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

constexpr std::uint32_t kUnnumbered = 0xffffffff;

/// New numbers for the corners that triangles use, in order.
std::vector<std::uint32_t> number_used_corners(const Corners& corners,
                                               const CellTriangles& triangles) {
  std::vector<std::uint32_t> numbers(corners.normal.size(), kUnnumbered);
  for (const Triangle& triangle : triangles.all) {
    for (const std::uint32_t corner : triangle) numbers[corner] = 0;
  }
  std::uint32_t count = 0;
  for (std::uint32_t& number : numbers) {
    if (number != kUnnumbered) number = count++;
  }
  return numbers;
}

/// The corners that are used, under their new numbers, and the triangles.
Mesh collect(const Grid& grid, const Corners& corners, const CellTriangles& triangles,
             const Joints& joints, std::span<const std::uint32_t> numbers) {
  Mesh mesh;
  mesh.position.reserve(numbers.size());
  mesh.normal.reserve(numbers.size());
  mesh.uv.reserve(numbers.size());
  mesh.point.reserve(numbers.size());
  std::vector<std::uint32_t> point_numbers(grid.points.size(), kUnnumbered);
  for (std::size_t corner = 0; corner < numbers.size(); ++corner) {
    if (numbers[corner] == kUnnumbered) continue;
    const std::uint32_t vertex = corners.vertex[corner];
    mesh.position.push_back(grid.points[vertex].position);
    mesh.normal.push_back(corners.normal[corner]);
    mesh.uv.push_back(grid.uv(vertex));
    mesh.bounds.add(mesh.position.back());
    std::uint32_t& point = point_numbers[joints.point[vertex]];
    if (point == kUnnumbered) point = mesh.point_count++;
    mesh.point.push_back(point);
  }
  mesh.triangles.reserve(triangles.all.size());
  for (const Triangle& t : triangles.all) {
    mesh.triangles.push_back({numbers[t[0]], numbers[t[1]], numbers[t[2]]});
  }
  return mesh;
}

/// For each vertex a corner of the mesh: its own, or one of the same point where a pole's triangles
/// use only their neighbours' corners.
std::vector<std::uint32_t> corners_for_lines(const Corners& corners, const Joints& joints,
                                             std::span<const std::uint32_t> numbers) {
  std::vector<std::uint32_t> own(joints.point.size(), kNoCorner);
  std::vector<std::uint32_t> of_point(joints.point.size(), kNoCorner);
  for (std::size_t corner = 0; corner < numbers.size(); ++corner) {
    if (numbers[corner] == kUnnumbered) continue;
    const std::uint32_t vertex = corners.vertex[corner];
    own[vertex] = numbers[corner];
    of_point[joints.point[vertex]] = numbers[corner];
  }
  for (std::size_t vertex = 0; vertex < own.size(); ++vertex) {
    if (own[vertex] == kNoCorner) own[vertex] = of_point[joints.point[vertex]];
  }
  return own;
}

void require_triangles(const CellTriangles& triangles, const Grid& grid) {
  if (!triangles.all.empty()) return;
  throw Error(Status::Nothing, "no cell of the grid has any area", {},
              "the surface repeats itself in step with the " + std::to_string(grid.cells_u) +
                  " x " + std::to_string(grid.cells_v) + " cells; --samples takes more");
}

}  // namespace

GridMesh mesh_on_grid(const Surface& surface, const GridOptions& options) {
  GridMesh result;
  MeshReport& report = result.report;
  Grid grid = sample_grid(surface, options);
  report.cells = grid.kept_count;
  report.evaluations = grid.points.size();
  report.undefined_fraction = static_cast<double>(grid.cell_count() - grid.kept_count) /
                              static_cast<double>(grid.cell_count());

  const std::vector<dvec3> normals = regular_normals(surface, grid, options.threads);
  require_two_dimensional(surface, grid, options.threads);
  const Joints joints = weld(grid);
  report.closed_u = joints.closed_u;
  report.closed_v = joints.closed_v;
  const Corners corners = make_corners(surface, grid, normals, options.threads, report);
  const CellTriangles triangles = triangulate(grid, corners, joints.point, options.threads);
  require_triangles(triangles, grid);
  report.flat_triangles = 2 * grid.kept_count - triangles.all.size();

  const std::vector<std::uint32_t> numbers = number_used_corners(corners, triangles);
  result.mesh = collect(grid, corners, triangles, joints, numbers);
  const std::vector<std::uint32_t> line_corners = corners_for_lines(corners, joints, numbers);
  result.mesh.lines = grid_lines(grid, triangles, {joints.point, line_corners}, options);

  const MeasuredError error = measure_error(surface, grid, corners, triangles, options.threads);
  report.max_error = error.distance;
  report.max_normal_error = error.normal_degrees;
  report.evaluations += error.evaluations;
  return result;
}

}  // namespace saddle
