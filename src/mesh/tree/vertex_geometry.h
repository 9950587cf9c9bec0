// The surface at the vertices of a cell tree: positions and normals, with one-sided limits where
// the formula has none.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <vector>

#include "mesh/features/point_singularities.h"
#include "mesh/features/removable.h"
#include "mesh/grid/grid.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/cell_marks.h"
#include "mesh/tree/dyadic_vertices.h"
#include "mesh/tree/revision_clock.h"
#include "surface/normal.h"

namespace saddle {

/// A place between two vertices.
struct Between {
  std::uint32_t a, b;
  dvec2 uv;
};

/// A place in units of the cell tree, and its parameters.
struct InnerPlace {
  dvec2 place;
  dvec2 uv;
};

/// Evaluates the surface at vertices, into grid.mesh, and repairs positions. A removable
/// singularity, as of sin(u)/u at 0, takes the position on which all places around it agree. A
/// position that is made of rounding does the same. Other undefined vertices are classified.
class VertexGeometry {
 public:
  /// Repairs the vertices of the root grid.
  VertexGeometry(const Surface& surface, Grid& grid, DyadicVertices& vertices,
                 RevisionClock& revisions, Effort& effort, unsigned threads);

  const Surface& surface() const { return surface_; }
  const Mesh& mesh() const { return grid_.mesh; }

  /// Creates and evaluates the middles of the root cells and of their sides. As three grids they
  /// take a fraction of the time of single places.
  void add_middles(unsigned threads);
  /// Evaluates the vertices that are new, and returns them.
  std::vector<std::uint32_t> evaluate(unsigned threads);
  /// Whether a vertex is a sample that can be forgotten; nothing is special at it.
  bool can_forget(std::uint32_t vertex) const {
    return is_regular(vertex) && is_defined(vertex) && vertices_.can_forget(vertex);
  }
  /// Creates and evaluates vertices between neighbours, with consecutive numbers. Returns the
  /// first. All other vertices have been evaluated.
  std::uint32_t add_between(std::span<const Between> places, unsigned threads);
  /// The same for vertices inside of leaves.
  std::uint32_t add_inside(std::span<const InnerPlace> places, unsigned threads);
  /// Sets the normals of new vertices at which tangents are almost parallel and the normal is known
  /// otherwise. Follows add_between() and limits that are set there.
  void take_known_normals();
  /// Places at which the surface was evaluated.
  std::size_t evaluations() const { return evaluations_; }

  /// Whether the position is finite.
  bool is_defined(std::uint32_t vertex) const { return defined_[vertex] != 0; }
  /// The kind of the point singularity at an undefined vertex.
  PointSingularity::Kind singularity(std::uint32_t vertex) const {
    const auto found = singularities_.find(vertex);
    return found == singularities_.end() ? PointSingularity::Kind::Region : found->second.kind;
  }
  /// Point singularities that are no regions, by their vertices.
  const std::map<std::uint32_t, PointSingularity>& singularities() const { return singularities_; }
  /// Whether one of them is a pole.
  bool has_poles() const { return has_poles_; }

  /// Whether r_u x r_v has a direction at a vertex.
  bool is_regular(std::uint32_t vertex) const { return regular_[vertex] != 0; }
  /// The same at a corner of the mesh. One that was added for a limit of normals is at a singular
  /// vertex.
  bool is_regular_corner(std::uint32_t corner) const {
    return corner < regular_.size() && is_regular(corner);
  }
  bool has_singular() const { return std::ranges::find(regular_, 0) != regular_.end(); }
  /// The root cells around defined vertices that are not regular, and around some that were not.
  const CellMarks& singular_cells() const { return singular_cells_; }
  void make_singular(std::uint32_t vertex) {
    if (!is_regular(vertex)) return;
    regular_[vertex] = 0;
    const dvec2 place = vertices_.place_between(vertex);
    if (is_defined(vertex)) singular_cells_.add(place);
    revisions_.mark(place);
  }
  /// Sets the one-sided limit of the normals at a vertex, which becomes regular.
  void set_normal(std::uint32_t vertex, const dvec3& normal) {
    grid_.mesh.normal[vertex] = normal;
    regular_[vertex] = 1;
  }
  /// Makes the new vertex `to` one point with `from`, at its position.
  void join(std::uint32_t from, std::uint32_t to);

 private:
  /// Calls f for each array with an element for each vertex.
  template <class F>
  void for_arrays(F f) {
    f(grid_.mesh.position);
    f(grid_.mesh.normal);
    f(grid_.mesh.uv);
    f(grid_.mesh.point);
    f(regular_);
    f(defined_);
  }
  void reserve(std::size_t count);
  void resize();
  void evaluate_at(std::span<const std::uint32_t> vertices, std::span<const double> u,
                   std::span<const double> v, unsigned threads);
  std::vector<std::uint32_t> append_grid(const DyadicVertices::Lines& lines, unsigned threads);
  /// Stores what was computed at uv(i) for vertex(i).
  template <class Vertex, class Uv>
  void store(const NormalColumns& columns, std::size_t count, Vertex vertex, Uv uv);
  void finish_new(std::span<const std::uint32_t> vertices, unsigned threads);
  void repair_root_grid(unsigned threads);
  void replace_rounding_of_root_grid(unsigned threads);
  std::vector<std::uint32_t> drop_values_on_poles(std::span<const std::uint32_t> vertices,
                                                  unsigned threads);
  void fill_removable(std::span<const std::uint32_t> undefined, unsigned threads);
  void fill_at_jumps(std::span<const std::uint32_t> vertices, unsigned threads,
                     std::vector<std::uint32_t>& rest);
  void note_rounding(std::span<const std::size_t> vertices, std::span<const SurfacePoint> points);
  void replace_rounding(unsigned threads);
  std::vector<Beside> look_beside(std::span<const std::uint32_t> vertices, double diagonal,
                                  unsigned threads);
  void fill(std::uint32_t vertex, const dvec3& limit);
  void fill_from_ends(const Between& between, std::size_t vertex);
  void classify(std::span<const std::uint32_t> vertices, unsigned threads);
  void join_pole(std::uint32_t vertex);

  const Surface& surface_;
  const bool may_have_values_on_poles_;
  Grid& grid_;
  DyadicVertices& vertices_;
  RevisionClock& revisions_;
  Effort& effort_;
  double size_;  // of the surface, without positions that are rounding
  std::vector<std::uint8_t> regular_;
  std::vector<std::uint8_t> defined_;
  CellMarks singular_cells_;
  std::map<std::uint32_t, PointSingularity> singularities_;
  bool has_poles_ = false;
  std::vector<std::size_t> steep_;      // new ones whose tangents are almost parallel, or very long
  std::vector<std::uint32_t> rounded_;  // whose positions are rounding, and not replaced yet
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
