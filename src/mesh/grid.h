// The samples that a grid mesh is made from, and what is known about its vertices and cells.
// Vertices and cells are numbered with u inner. The corners of cell (i, j) are slots 0 to 3:
// (i, j), (i+1, j), (i+1, j+1), (i, j+1).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/grid_mesh.h"

namespace saddle {

/// What is lost to rounding in a coordinate: a few operations' worth. Differences up to this are
/// none. Each coordinate has its own, so that a spike in one does not swallow the others.
inline constexpr double kRounding = 4 * std::numeric_limits<double>::epsilon();
inline dvec3 rounding(const dvec3& position) {
  return kRounding * glm::abs(position);
}

/// Vertices of one line of the grid, of constant u or of constant v.
struct GridLine {
  std::size_t first;
  std::size_t stride;
  std::size_t count;
  std::size_t operator[](std::size_t k) const { return first + k * stride; }
};

struct Grid {
  std::size_t cells_u = 0;
  std::size_t cells_v = 0;
  std::vector<double> u;  ///< cells_u + 1 parameters
  std::vector<double> v;
  std::vector<SurfacePoint> points;       ///< one per vertex
  std::vector<dvec2> tangent_lengths;     ///< |r_u|, |r_v| per vertex; 0 where not finite
  std::vector<std::uint8_t> cell_kept;    ///< all four corners have finite positions
  std::vector<std::uint8_t> vertex_used;  ///< a corner of a kept cell
  std::size_t kept_count = 0;
  double local_scale = 1;  ///< local units per unit of length
  double diagonal = 0;     ///< of the box around the used vertices, in local units
  bool mirrored = false;   ///< slots 0 to 3 run clockwise seen from the front

  std::size_t cell_count() const { return cells_u * cells_v; }
  std::size_t vertex(std::size_t i, std::size_t j) const { return j * (cells_u + 1) + i; }
  std::size_t cell(std::size_t i, std::size_t j) const { return j * cells_u + i; }
  dvec2 uv(std::size_t vertex) const {
    return {u[vertex % (cells_u + 1)], v[vertex / (cells_u + 1)]};
  }
  dvec2 cell_centre(std::size_t cell) const;
  /// The vertices of a cell's four slots.
  std::array<std::size_t, 4> vertices(std::size_t cell) const;

  /// The line of constant u through column i, of constant v through row j.
  GridLine column(std::size_t i) const { return {i, cells_u + 1, cells_v + 1}; }
  GridLine row(std::size_t j) const { return {j * (cells_u + 1), 1, cells_u + 1}; }

  /// The position of a vertex in local units, in which the diagonal is 1 to 2 and squares and cubes
  /// of lengths neither overflow nor vanish. A power of two: the conversion is exact.
  dvec3 local(std::size_t vertex) const { return local_scale * points[vertex].position; }
  /// The largest |r_u| and |r_v| among the vertex and its neighbours.
  dvec2 tangent_scale(std::size_t vertex) const;

  /// Calls f(cell, slot) for each kept cell around a vertex; the vertex is the cell's `slot`.
  template <class F>
  void for_cells_around(std::size_t vertex, F f) const {
    const std::size_t i = vertex % (cells_u + 1);
    const std::size_t j = vertex / (cells_u + 1);
    const auto visit = [&](std::size_t ci, std::size_t cj, int slot) {
      if (ci < cells_u && cj < cells_v && cell_kept[cell(ci, cj)]) f(cell(ci, cj), slot);
    };
    visit(i - 1, j - 1, 2);  // i - 1 wraps around to a huge number at i = 0, which is no cell
    visit(i, j - 1, 3);
    visit(i - 1, j, 1);
    visit(i, j, 0);
  }
};

/// Evaluates the surface on the grid. Throws Error: Input for a grid whose corners could not be
/// numbered; Nothing where no cell has four defined corners, or all are one point, or too far apart
/// for a finite diagonal.
Grid sample_grid(const Surface& surface, const GridOptions& options);

}  // namespace saddle
