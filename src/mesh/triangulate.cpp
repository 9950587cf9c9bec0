#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>

#include <glm/vector_relational.hpp>

#include "base/parallel.h"

namespace saddle {

namespace {

constexpr std::size_t kCellChunk = 1024;
/// Sagittas and lengths that differ by less, relatively, are equal: on surfaces of revolution both
/// diagonals are, and rounding must not choose between them.
constexpr double kTie = 1e-6;

/// The triangle at slot k of a cell is (k - 1, k, k + 1). A cut along the diagonal from slot 0 to
/// slot 2 makes those at slots 1 and 3, one from 1 to 3 those at 2 and 0.
constexpr std::array<std::array<std::size_t, 2>, 2> kCuts = {{{1, 3}, {2, 0}}};

/// How one cell is cut.
struct Cut {
  std::uint8_t diagonal = 0;  ///< the slot that it starts from
  std::array<bool, 2> exists = {false, false};

  int count() const { return exists[0] + exists[1]; }
};

/// The four triangles that a cell can have, by slot.
struct SlotTriangles {
  std::array<bool, 4> exists;
  std::array<bool, 4> faces_front;  ///< faces as the normals of its corners do
};

/// What a cell is made of, by slot.
struct CellCorners {
  std::array<dvec3, 4> position;  ///< local
  std::array<dvec3, 4> normal;
  std::array<std::uint32_t, 4> point;
};

/// How far each component of a cross product of two of the edges can be from the truth because of
/// the rounding of the positions.
dvec3 rounding_of_areas(const std::array<dvec3, 4>& p, const std::array<dvec3, 4>& edges) {
  dvec3 reach(0);
  dvec3 size(0);
  for (std::size_t k = 0; k < 4; ++k) {
    reach = glm::max(reach, glm::abs(edges[k]));
    size = glm::max(size, glm::abs(p[k]));
  }
  const dvec3 least = rounding(size);
  return 2.0 * dvec3(least.y * reach.z + least.z * reach.y, least.z * reach.x + least.x * reach.z,
                     least.x * reach.y + least.y * reach.x);
}

/// A triangle is flat if its area is rounding, or if it is a needle whose width is to its length as
/// rounding is to 1: the spike over a sample beside a pole.
bool is_flat(const dvec3& area, const dvec3& least, const dvec3& edge_a, const dvec3& edge_b) {
  const double needle = kRounding * (glm::dot(edge_a, edge_a) + glm::dot(edge_b, edge_b));
  return glm::dot(area, area) <= needle * needle ||
         glm::all(glm::lessThanEqual(glm::abs(area), least));
}

SlotTriangles slot_triangles(const CellCorners& cell, bool mirrored) {
  const auto& [position, normal, point] = cell;
  std::array<dvec3, 4> edges;
  for (std::size_t k = 0; k < 4; ++k) edges[k] = position[(k + 1) % 4] - position[k];
  const dvec3 least = rounding_of_areas(position, edges);
  SlotTriangles result{};
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t before = (k + 3) % 4;
    const std::size_t after = (k + 1) % 4;
    const bool collapsed =
        point[before] == point[k] || point[k] == point[after] || point[after] == point[before];
    const dvec3 area = glm::cross(edges[before], edges[k]);
    result.exists[k] = !collapsed && !is_flat(area, least, edges[before], edges[k]);
    const double front = glm::dot(area, normal[before] + normal[k] + normal[after]);
    result.faces_front[k] = mirrored ? front < 0 : front > 0;
  }
  return result;
}

/// Whether the diagonal from slot 1 to 3 is better than that from 0 to 2, where both cuts make
/// triangles that are equally good.
bool second_diagonal_is_nearer(const CellCorners& cell) {
  const auto smaller = [](double x, double y) { return x < y * (1 - kTie); };
  const auto& [p, n, point] = cell;
  const double first = sagitta(p[0], n[0], p[2], n[2]);
  const double second = sagitta(p[1], n[1], p[3], n[3]);
  if (smaller(second, first)) return true;
  if (smaller(first, second)) return false;
  return smaller(glm::distance(p[1], p[3]), glm::distance(p[0], p[2]));
}

Cut cut_cell(const CellCorners& cell, bool mirrored) {
  const SlotTriangles triangles = slot_triangles(cell, mirrored);
  std::array<Cut, 2> cuts;
  std::array<int, 2> facing{};
  for (std::uint8_t d = 0; d < 2; ++d) {
    cuts[d].diagonal = d;
    for (std::size_t t = 0; t < 2; ++t) {
      const std::size_t slot = kCuts[d][t];
      cuts[d].exists[t] = triangles.exists[slot];
      facing[d] += triangles.exists[slot] && triangles.faces_front[slot];
    }
  }
  if (cuts[0].count() != cuts[1].count()) return cuts[cuts[1].count() > cuts[0].count()];
  if (facing[0] != facing[1]) return cuts[facing[1] > facing[0]];
  return cuts[second_diagonal_is_nearer(cell)];
}

CellCorners gather(const Grid& grid, const Corners& corners, std::span<const std::uint32_t> point,
                   std::size_t cell) {
  CellCorners result;
  const auto vertices = grid.vertices(cell);
  for (std::size_t k = 0; k < 4; ++k) {
    result.position[k] = grid.local(vertices[k]);
    result.normal[k] = corners.normal[corners.of_cell[cell][k]];
    result.point[k] = point[vertices[k]];
  }
  return result;
}

}  // namespace

CellTriangles triangulate(const Grid& grid, const Corners& corners,
                          std::span<const std::uint32_t> point, unsigned threads) {
  std::vector<Cut> cuts(grid.cell_count());
  parallel_chunks(cuts.size(), kCellChunk, threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t cell = begin; cell < end; ++cell) {
      if (!grid.cell_kept[cell]) continue;
      cuts[cell] = cut_cell(gather(grid, corners, point, cell), grid.mirrored);
    }
  });

  CellTriangles triangles;
  triangles.all.reserve(2 * grid.kept_count);
  triangles.first.reserve(cuts.size() + 1);
  for (std::size_t cell = 0; cell < cuts.size(); ++cell) {
    triangles.first.push_back(static_cast<std::uint32_t>(triangles.all.size()));
    const auto& corner = corners.of_cell[cell];
    for (std::size_t t = 0; t < 2; ++t) {
      if (!cuts[cell].exists[t]) continue;
      const std::size_t slot = kCuts[cuts[cell].diagonal][t];
      Triangle triangle = {corner[(slot + 3) % 4], corner[slot], corner[(slot + 1) % 4]};
      if (grid.mirrored) std::swap(triangle[1], triangle[2]);
      triangles.all.push_back(triangle);
    }
  }
  triangles.first.push_back(static_cast<std::uint32_t>(triangles.all.size()));
  return triangles;
}

}  // namespace saddle
