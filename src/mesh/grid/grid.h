// A tensor grid of samples and its mesh while it is being made: vertices and triangles in their
// final places, and the state of each cell. One pass (mesh/grid/tile) samples the surface and cuts
// plain cells into two triangles; the others stay open until their vertices are welded and given
// corners.
// Vertices and cells are numbered with u inner; vertex k is corner k of the mesh, and further
// corners follow. The corners of cell (i, j) are slots 0 to 3: (i, j), (i+1, j), (i+1, j+1),
// (i, j+1).
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"
#include "mesh/model/tolerances.h"
#include "surface/surface.h"

namespace saddle {

/// The rounding error of a position. Each coordinate has its own, so that a spike in one does not
/// swallow the others.
inline dvec3 rounding_of(const dvec3& position) {
  return kRounding * glm::abs(position);
}

/// The state of a cell. The triangles of cell c are mesh.triangles[2c] and [2c + 1].
enum class GridCell : std::uint8_t {
  Empty,    ///< without area: no triangle
  One,      ///< one triangle
  Two,      ///< two
  Open,     ///< not cut yet: not plain
  LeftOut,  ///< a corner's position is not finite
};

/// Vertices of one line of the grid, of constant u or of constant v.
struct GridLine {
  std::size_t first;
  std::size_t stride;
  std::size_t count;
  std::size_t operator[](std::size_t k) const { return first + k * stride; }
};

/// A cell and the height of its arcs above the mesh, estimated; in units of length.
struct CellSagitta {
  std::size_t cell;
  double sagitta;
};

struct Grid {
  std::size_t cells_u = 0;
  std::size_t cells_v = 0;
  std::vector<double> u;  ///< cells_u + 1 parameters
  std::vector<double> v;
  Mesh mesh;
  Array<GridCell> cells;
  std::size_t left_out_count = 0;
  std::vector<std::size_t> singular;  ///< used vertices without a regular normal, ascending
  std::vector<CellSagitta> worst;     ///< the largest sagitta of each 16 plain cells
  dvec2 longest_tangents{0};          ///< |r_u| and |r_v| of vertices; infinite where unknown
  double local_scale = 1;             ///< local units per unit of length
  double diagonal = 0;                ///< of the box around the used vertices, in local units
  dvec2 range{1};                     ///< of the parameters, or of the small component in it
  bool flipped = false;               ///< normals are along r_v x r_u
  bool mirrored = false;              ///< slots 0 to 3 run clockwise seen from the front

  std::size_t vertex_count() const { return u.size() * v.size(); }
  std::size_t cell_count() const { return cells_u * cells_v; }
  std::size_t vertex(std::size_t i, std::size_t j) const { return j * (cells_u + 1) + i; }
  std::size_t cell(std::size_t i, std::size_t j) const { return j * cells_u + i; }
  dvec2 uv(std::size_t vertex) const {
    return {u[vertex % (cells_u + 1)], v[vertex / (cells_u + 1)]};
  }
  dvec2 cell_centre(std::size_t cell) const;
  /// The vertices of a cell's four slots.
  std::array<std::size_t, 4> vertices(std::size_t cell) const;
  bool is_kept(std::size_t cell) const { return cells[cell] != GridCell::LeftOut; }
  std::size_t triangle_count(std::size_t cell) const {
    return cells[cell] <= GridCell::Two ? static_cast<std::size_t>(cells[cell]) : 0;
  }
  std::span<const Triangle> triangles(std::size_t cell) const {
    return std::span(mesh.triangles).subspan(2 * cell, triangle_count(cell));
  }
  /// Whether the vertex is a corner of a kept cell.
  bool is_used(std::size_t vertex) const;
  /// Frees the triangles. The cells that had some are open.
  void forget_triangles();
  /// Marks the kept cells around a vertex as open.
  void open_around(std::size_t vertex);

  /// The line of constant u through column i, of constant v through row j.
  GridLine column(std::size_t i) const { return {i, cells_u + 1, cells_v + 1}; }
  GridLine row(std::size_t j) const { return {j * (cells_u + 1), 1, cells_u + 1}; }

  /// The position of a corner in local units. The diagonal is 1 to 2 of them, so that squares and
  /// cubes of lengths neither overflow nor vanish. The factor is a power of two: conversion is
  /// exact.
  dvec3 local(std::size_t corner) const { return local_scale * mesh.position[corner]; }

  /// Calls f(cell, slot) for each kept cell around a vertex; the vertex is the cell's `slot`.
  template <class F>
  void for_cells_around(std::size_t vertex, F f) const {
    const std::size_t i = vertex % (cells_u + 1);
    const std::size_t j = vertex / (cells_u + 1);
    const auto visit = [&](std::size_t ci, std::size_t cj, std::size_t slot) {
      if (ci < cells_u && cj < cells_v && is_kept(cell(ci, cj))) f(cell(ci, cj), slot);
    };
    visit(i - 1, j - 1, 2);  // i - 1 wraps around to a huge number at i = 0, which is no cell
    visit(i, j - 1, 3);
    visit(i - 1, j, 1);
    visit(i, j, 0);
  }
};

/// Sets the box around the vertices, and the local units. Throws Error (Nothing) if the box is a
/// point or has no finite diagonal.
void set_extent(Grid& grid, const Bounds& bounds);

/// Throws Error (Nothing) if no cell is kept: the surface is undefined, or defined only at isolated
/// samples.
void require_defined_cells(const Grid& grid);

}  // namespace saddle
