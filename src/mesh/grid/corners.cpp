#include "mesh/grid/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// The way from a cell's corner to its middle, times this, stays within the cell and meets no line
/// between dyadic points.
constexpr dvec2 kAslant(1.4142135623730951, 0.6180339887498949);

/// The kept cells around all singular vertices, in order of vertex, then of cell.
std::vector<Approach> singular_approaches(const Grid& grid) {
  std::vector<Approach> approaches;
  for (const std::size_t vertex : grid.singular) {
    grid.for_cells_around(vertex, [&](std::size_t cell, std::size_t) {
      approaches.push_back({grid.uv(vertex), grid.cell_centre(cell)});
    });
  }
  return approaches;
}

/// The normal of a cell's face on its front: the longest among the vector areas of the cell and of
/// the four triangles at its corners; zero if the cell has none.
dvec3 face_normal(const Grid& grid, std::size_t cell) {
  const auto vertices = grid.vertices(cell);
  std::array<dvec3, 4> p;
  for (std::size_t k = 0; k < 4; ++k) p[k] = grid.local(vertices[k]);
  dvec3 area = glm::cross(p[2] - p[0], p[3] - p[1]);
  for (std::size_t k = 0; k < 4; ++k) {
    const dvec3 at_corner = glm::cross(p[(k + 1) % 4] - p[k], p[(k + 3) % 4] - p[k]);
    if (glm::length(at_corner) > glm::length(area)) area = at_corner;
  }
  return front_normal(grid, area);
}

class CornerBuilder {
 public:
  CornerBuilder(Grid& grid, MeshReport& report)
      : grid_(grid), report_(report), corners_(grid.mesh) {
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      if (grid.cells[cell] != GridCell::Open) continue;
      OpenCell& open = cells_.emplace_back(OpenCell{cell, {}});
      std::ranges::copy(grid.vertices(cell), open.corners.begin());
    }
  }

  /// Takes the limits of the cells around the vertex from the front of `limits`.
  void add_singular(std::size_t vertex, std::span<const NormalLimit>& limits) {
    corners_.begin(vertex);
    add_singular_point(grid_.uv(vertex), report_);
    grid_.for_cells_around(vertex, [&](std::size_t cell, std::size_t slot) {
      const NormalLimit& limit = limits.front();
      if (!limit.normal) mark_without_limit(report_);
      const dvec3 normal = limit.normal ? *limit.normal : face_normal(grid_, cell);
      find(cell).corners[slot] = static_cast<std::uint32_t>(corners_.find_or_add(normal));
      limits = limits.subspan(1);
    });
  }

  std::vector<OpenCell> take() { return std::move(cells_); }

 private:
  OpenCell& find(std::size_t cell) {
    return *std::ranges::lower_bound(cells_, cell, {}, &OpenCell::cell);
  }

  Grid& grid_;
  MeshReport& report_;
  std::vector<OpenCell> cells_;
  VertexCorners corners_;
};

}  // namespace

dvec3 front_normal(const Grid& grid, const dvec3& area) {
  const double length = glm::length(area);
  if (!(length > 0)) return dvec3(0);
  return (grid.mirrored ? -area : area) / length;
}

void VertexCorners::begin(std::size_t vertex) {
  vertex_ = vertex;
  own_is_free_ = true;
  first_new_ = mesh_.normal.size();
}

std::size_t VertexCorners::find_or_add(const dvec3& normal) {
  if (own_is_free_) {
    own_is_free_ = false;
    mesh_.normal[vertex_] = normal;
    return vertex_;
  }
  static const double kCreaseCosine = std::cos(kCreaseDegrees * std::numbers::pi / 180);
  const auto agrees = [&](std::size_t corner) {
    return glm::dot(mesh_.normal[corner], normal) >= kCreaseCosine;
  };
  if (agrees(vertex_)) return vertex_;
  for (std::size_t corner = first_new_; corner < mesh_.normal.size(); ++corner) {
    if (agrees(corner)) return corner;
  }
  return add_corner(mesh_, vertex_, normal);
}

std::uint32_t add_corner(Mesh& mesh, std::size_t like, const dvec3& normal) {
  mesh.position.push_back(dvec3(mesh.position[like]));
  mesh.normal.push_back(normal);
  mesh.uv.push_back(dvec2(mesh.uv[like]));
  mesh.point.push_back(std::uint32_t{mesh.point[like]});
  return static_cast<std::uint32_t>(mesh.position.size() - 1);
}

std::vector<NormalLimit> limits_in_cells(const Surface& surface, std::vector<Approach> approaches,
                                         unsigned threads) {
  std::vector<dvec2> corners;
  corners.reserve(approaches.size());
  for (const Approach& approach : approaches) corners.push_back(approach.corner);
  const std::vector<SurfacePoint> points = evaluate(surface, corners, threads);
  for (std::size_t k = 0; k < points.size(); ++k) {
    auto& [corner, inside] = approaches[k];
    if (!is_finite(points[k].position)) inside = corner + kAslant * (inside - corner);
  }
  return limit_normals(surface, approaches, threads);
}

std::vector<OpenCell> open_cells(const Surface& surface, unsigned threads, Grid& grid,
                                 MeshReport& report) {
  const std::vector<NormalLimit> limits =
      limits_in_cells(surface, singular_approaches(grid), threads);
  std::span<const NormalLimit> remaining = limits;
  CornerBuilder builder(grid, report);
  for (const std::size_t vertex : grid.singular) builder.add_singular(vertex, remaining);
  return builder.take();
}

}  // namespace saddle
