#include "mesh/grid/triangulate.h"

#include <algorithm>
#include <cmath>

#include <glm/vector_relational.hpp>

namespace saddle {

namespace {

/// The triangle at slot k of a cell is (k - 1, k, k + 1). A cut along the diagonal from slot 0 to
/// slot 2 makes those at slots 1 and 3, one from 1 to 3 those at 2 and 0.
constexpr std::array<std::array<std::size_t, 2>, 2> kCuts = {{{1, 3}, {2, 0}}};

/// How one cell is cut.
struct CellCut {
  std::uint8_t diagonal = 0;  ///< the slot that it starts from
  std::array<bool, 2> exists = {false, false};

  int count() const { return exists[0] + exists[1]; }
};

/// The four triangles that a cell can have, by slot.
struct SlotTriangles {
  std::array<bool, 4> exists;
  std::array<bool, 4> faces_front;  ///< faces as the normals of its corners do
};

/// The corners of a cell, by slot.
struct CellCorners {
  std::array<dvec3, 4> position;  ///< local
  std::array<dvec3, 4> normal;
  std::array<std::uint32_t, 4> point;
};

/// A bound on the error of each component of a cross product of two edges, by the rounding of the
/// positions.
dvec3 rounding_of_areas(const std::array<dvec3, 4>& p, const std::array<dvec3, 4>& edges) {
  dvec3 reach(0);
  dvec3 size(0);
  for (std::size_t k = 0; k < 4; ++k) {
    reach = glm::max(reach, glm::abs(edges[k]));
    size = glm::max(size, glm::abs(p[k]));
  }
  const dvec3 least = rounding_of(size);
  return 2.0 * dvec3(least.y * reach.z + least.z * reach.y, least.z * reach.x + least.x * reach.z,
                     least.x * reach.y + least.y * reach.x);
}

/// A triangle is flat if its area is within rounding. So is a needle with a width of kRounding
/// times its length, like the spike over a sample beside a pole.
bool is_flat_corner(const dvec3& area, const dvec3& least, const dvec3& edge_a,
                    const dvec3& edge_b) {
  const double needle = kRounding * (glm::dot(edge_a, edge_a) + glm::dot(edge_b, edge_b));
  return glm::dot(area, area) <= needle * needle ||
         glm::all(glm::lessThanEqual(glm::abs(area), least));
}

/// Whether a triangle with a corner at `place` is not flat, by a coarser bound that costs less.
bool is_surely_not_flat(const dvec3& place, const dvec3& edge_a, const dvec3& edge_b,
                        const dvec3& area) {
  // Bounds on the squares of edges and of coordinates.
  const double edges = 2 * (glm::dot(edge_a, edge_a) + glm::dot(edge_b, edge_b));
  const double coordinates = 2 * (glm::dot(place, place) + edges);
  // The larger of the squares of an area's rounding and of a needle's area.
  const double least = std::max(16 * edges * coordinates, edges * edges);
  return glm::dot(area, area) > kRounding * kRounding * 3 * least;
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
    result.exists[k] = !collapsed && !is_flat_corner(area, least, edges[before], edges[k]);
    const double front = glm::dot(area, normal[before] + normal[k] + normal[after]);
    result.faces_front[k] = mirrored ? front < 0 : front > 0;
  }
  return result;
}

/// Whether the diagonal from slot 1 to 3 is better than that from 0 to 2, where both cuts make
/// triangles that are equally good.
bool second_diagonal_is_nearer(const CellCorners& cell) {
  const auto& p = cell.position;
  const auto& n = cell.normal;
  const auto diagonal = [&](std::size_t a, std::size_t b) {
    const dvec3 along = p[b] - p[a];
    return Diagonal{sagitta(p[a], n[a], p[b], n[b]), glm::dot(along, along)};
  };
  return is_nearer(diagonal(1, 3), diagonal(0, 2));
}

CellCut cut_cell(const CellCorners& cell, bool mirrored) {
  const SlotTriangles triangles = slot_triangles(cell, mirrored);
  std::array<CellCut, 2> cuts;
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

CellCorners gather(const Grid& grid, const std::array<std::uint32_t, 4>& corners) {
  CellCorners result;
  for (std::size_t k = 0; k < 4; ++k) {
    result.position[k] = grid.local(corners[k]);
    result.normal[k] = grid.mesh.normal[corners[k]];
    result.point[k] = grid.mesh.point[corners[k]];
  }
  return result;
}

}  // namespace

std::size_t triangles_between(std::vector<std::uint32_t>& points) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  while (points.size() > 1 && points.front() == points.back()) points.pop_back();
  return points.size() > 2 ? points.size() - 2 : 0;
}

bool is_collapsed(const Grid& grid, const Triangle& t) {
  const auto& point = grid.mesh.point;
  if (point[t[0]] == point[t[1]] || point[t[1]] == point[t[2]] || point[t[2]] == point[t[0]]) {
    return true;
  }
  const std::array<dvec3, 4> p = {grid.local(t[0]), grid.local(t[1]), grid.local(t[2]),
                                  grid.local(t[2])};
  const std::array<dvec3, 4> edges = {p[1] - p[0], p[2] - p[1], p[0] - p[2], dvec3(0)};
  const dvec3 area = glm::cross(edges[0], edges[1]);
  if (is_surely_not_flat(p[0], edges[0], edges[1], area)) return false;
  return is_flat_corner(area, rounding_of_areas(p, edges), edges[0], edges[1]);
}

void cut_cell(const Grid& grid, const std::array<std::uint32_t, 4>& corners,
              Array<Triangle>& triangles) {
  const CellCut cut = cut_cell(gather(grid, corners), grid.mirrored);
  for (std::size_t t = 0; t < 2; ++t) {
    if (!cut.exists[t]) continue;
    const std::size_t slot = kCuts[cut.diagonal][t];
    Triangle triangle = {corners[(slot + 3) % 4], corners[slot], corners[(slot + 1) % 4]};
    if (grid.mirrored) std::swap(triangle[1], triangle[2]);
    triangles.push_back(triangle);
  }
}

void triangulate(Grid& grid, std::span<const OpenCell> cells) {
  Array<Triangle> triangles;
  for (const OpenCell& cell : cells) {
    triangles.clear();
    cut_cell(grid, cell.corners, triangles);
    std::ranges::copy(triangles,
                      grid.mesh.triangles.begin() + 2 * static_cast<std::ptrdiff_t>(cell.cell));
    grid.cells[cell.cell] = static_cast<GridCell>(triangles.size());
  }
}

}  // namespace saddle
