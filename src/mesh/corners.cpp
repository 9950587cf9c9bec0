#include "mesh/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "surface/normal.h"

namespace saddle {

namespace {

constexpr std::size_t kMaxListed = 1000;  // singular points named in a report

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
  const double length = glm::length(area);
  if (!(length > 0)) return dvec3(0);
  return (grid.mirrored ? -area : area) / length;
}

class CornerBuilder {
 public:
  CornerBuilder(Grid& grid, MeshReport& report) : grid_(grid), report_(report) {
    for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
      if (grid.cells[cell] != Cell::Open) continue;
      OpenCell& open = cells_.emplace_back(OpenCell{cell, {}});
      std::ranges::copy(grid.vertices(cell), open.corners.begin());
    }
  }

  /// Takes the limits of the cells around the vertex from the front of `limits`.
  void add_singular(std::size_t vertex, std::span<const NormalLimit>& limits) {
    own_corner_is_free_ = true;
    first_new_corner_ = grid_.mesh.normal.size();
    bool has_limit = true;
    grid_.for_cells_around(vertex, [&](std::size_t cell, std::size_t slot) {
      const NormalLimit& limit = limits.front();
      has_limit = has_limit && limit.normal.has_value();
      report_.evaluations += static_cast<std::size_t>(limit.evaluations);
      const dvec3 normal = limit.normal ? *limit.normal : face_normal(grid_, cell);
      find(cell).corners[slot] = static_cast<std::uint32_t>(find_or_add(vertex, normal));
      limits = limits.subspan(1);
    });
    ++report_.singular_point_count;
    if (report_.singular_points.size() < kMaxListed) {
      report_.singular_points.push_back({grid_.uv(vertex), has_limit});
    }
  }

  std::vector<OpenCell> take() { return std::move(cells_); }

 private:
  OpenCell& find(std::size_t cell) {
    return *std::ranges::lower_bound(cells_, cell, {}, &OpenCell::cell);
  }

  /// A corner of the vertex with nearly this normal; its own if that is still free, else a new one.
  std::size_t find_or_add(std::size_t vertex, const dvec3& normal) {
    Mesh& mesh = grid_.mesh;
    if (own_corner_is_free_) {
      own_corner_is_free_ = false;
      mesh.normal[vertex] = normal;
      return vertex;
    }
    const auto agrees = [&](std::size_t corner) {
      return glm::dot(mesh.normal[corner], normal) >= crease_cosine_;
    };
    if (agrees(vertex)) return vertex;
    for (std::size_t corner = first_new_corner_; corner < mesh.normal.size(); ++corner) {
      if (agrees(corner)) return corner;
    }
    mesh.position.push_back(dvec3(mesh.position[vertex]));
    mesh.normal.push_back(normal);
    mesh.uv.push_back(grid_.uv(vertex));
    mesh.point.push_back(std::uint32_t{mesh.point[vertex]});
    return mesh.normal.size() - 1;
  }

  Grid& grid_;
  MeshReport& report_;
  std::vector<OpenCell> cells_;
  bool own_corner_is_free_ = true;    // of the vertex at hand
  std::size_t first_new_corner_ = 0;  // of the vertex at hand
  const double crease_cosine_ = std::cos(kCreaseDegrees * std::numbers::pi / 180);
};

}  // namespace

std::vector<OpenCell> open_cells(const Surface& surface, unsigned threads, Grid& grid,
                                 MeshReport& report) {
  const std::vector<NormalLimit> limits =
      limit_normals(surface, singular_approaches(grid), threads);
  std::span<const NormalLimit> remaining = limits;
  CornerBuilder builder(grid, report);
  for (const std::size_t vertex : grid.singular) builder.add_singular(vertex, remaining);
  return builder.take();
}

}  // namespace saddle
