#include "mesh/corners.h"

#include <cmath>
#include <numbers>

#include "base/parallel.h"
#include "surface/normal.h"

namespace saddle {

namespace {

constexpr std::size_t kVertexChunk = 2048;
constexpr std::size_t kMaxListed = 1000;  // singular points named in a report

bool is_zero(const dvec3& a) {
  return a == dvec3(0);
}

/// The cells around all singular vertices, in order of vertex, then of cell.
std::vector<Approach> singular_approaches(const Grid& grid, std::span<const dvec3> normals) {
  std::vector<Approach> approaches;
  for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
    if (!grid.vertex_used[vertex] || !is_zero(normals[vertex])) continue;
    grid.for_cells_around(vertex, [&](std::size_t cell, int) {
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
  CornerBuilder(const Grid& grid, MeshReport& report) : grid_(grid), report_(report) {
    corners_.of_cell.resize(grid.cell_count());
    corners_.normal.reserve(grid.points.size());
    corners_.vertex.reserve(grid.points.size());
  }

  void add_regular(std::size_t vertex, const dvec3& normal) {
    const std::uint32_t corner = add(vertex, normal);
    grid_.for_cells_around(vertex, [&](std::size_t cell, int slot) {
      corners_.of_cell[cell][static_cast<std::size_t>(slot)] = corner;
    });
  }

  /// Takes the limits of the cells around the vertex from the front of `limits`.
  void add_singular(std::size_t vertex, std::span<const NormalLimit>& limits) {
    const auto first = static_cast<std::uint32_t>(corners_.normal.size());
    bool has_limit = true;
    grid_.for_cells_around(vertex, [&](std::size_t cell, int slot) {
      const NormalLimit& limit = limits.front();
      has_limit = has_limit && limit.normal.has_value();
      report_.evaluations += static_cast<std::size_t>(limit.evaluations);
      const dvec3 normal = limit.normal ? *limit.normal : face_normal(grid_, cell);
      corners_.of_cell[cell][static_cast<std::size_t>(slot)] = find_or_add(first, vertex, normal);
      limits = limits.subspan(1);
    });
    ++report_.singular_point_count;
    if (report_.singular_points.size() < kMaxListed) {
      report_.singular_points.push_back({grid_.uv(vertex), has_limit});
    }
  }

  Corners take() { return std::move(corners_); }

 private:
  std::uint32_t add(std::size_t vertex, const dvec3& normal) {
    corners_.normal.push_back(normal);
    corners_.vertex.push_back(static_cast<std::uint32_t>(vertex));
    return static_cast<std::uint32_t>(corners_.normal.size() - 1);
  }

  /// A corner of the same vertex, from `first` on, with nearly this normal; else a new one.
  std::uint32_t find_or_add(std::uint32_t first, std::size_t vertex, const dvec3& normal) {
    for (std::uint32_t corner = first; corner < corners_.normal.size(); ++corner) {
      if (glm::dot(corners_.normal[corner], normal) >= crease_cosine_) return corner;
    }
    return add(vertex, normal);
  }

  const Grid& grid_;
  MeshReport& report_;
  Corners corners_;
  const double crease_cosine_ = std::cos(kCreaseDegrees * std::numbers::pi / 180);
};

}  // namespace

std::vector<dvec3> regular_normals(const Surface& surface, const Grid& grid, unsigned threads) {
  std::vector<dvec3> normals(grid.points.size(), dvec3(0));
  const auto compute = [&](std::size_t begin, std::size_t end) {
    for (std::size_t vertex = begin; vertex < end; ++vertex) {
      if (!grid.vertex_used[vertex]) continue;
      const dvec2 scale = grid.tangent_scale(vertex);
      const auto normal = unit_normal(grid.points[vertex], scale.x, scale.y, surface.flip);
      if (normal) normals[vertex] = *normal;
    }
  };
  parallel_chunks(normals.size(), kVertexChunk, threads, compute);
  return normals;
}

Corners make_corners(const Surface& surface, const Grid& grid, std::span<const dvec3> normals,
                     unsigned threads, MeshReport& report) {
  const std::vector<NormalLimit> limits =
      limit_normals(surface, singular_approaches(grid, normals), threads);
  std::span<const NormalLimit> remaining = limits;
  CornerBuilder builder(grid, report);
  for (std::size_t vertex = 0; vertex < normals.size(); ++vertex) {
    if (!grid.vertex_used[vertex]) continue;
    if (is_zero(normals[vertex])) {
      builder.add_singular(vertex, remaining);
    } else {
      builder.add_regular(vertex, normals[vertex]);
    }
  }
  return builder.take();
}

}  // namespace saddle
