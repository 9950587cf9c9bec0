// Cells of a grid into triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/corners.h"
#include "mesh/grid.h"

namespace saddle {

using Triangle = std::array<std::uint32_t, 3>;

/// Triangles of corners, counter-clockwise seen from the front; those of cell c are
/// all[first[c]] to all[first[c + 1] - 1], none to two.
struct CellTriangles {
  std::vector<Triangle> all;
  std::vector<std::uint32_t> first;  ///< one per cell, and the end

  std::span<const Triangle> of(std::size_t cell) const {
    return std::span(all).subspan(first[cell], first[cell + 1] - first[cell]);
  }
};

/// Cuts each kept cell along one of its diagonals: the one whose triangles face as their corners'
/// normals do, then the one with the smaller sagitta, then the shorter one. Triangles without area,
/// as at poles, are left out. `point`: see Joints.
CellTriangles triangulate(const Grid& grid, const Corners& corners,
                          std::span<const std::uint32_t> point, unsigned threads);

/// The height of a surface's arc above the chord from a to b, from the normals at its ends, for a
/// parabolic arc: |(n_b - n_a) . (p_b - p_a)| / 8.
inline double sagitta(const dvec3& p_a, const dvec3& n_a, const dvec3& p_b, const dvec3& n_b) {
  return 0.125 * glm::abs(glm::dot(n_b - n_a, p_b - p_a));
}

}  // namespace saddle
