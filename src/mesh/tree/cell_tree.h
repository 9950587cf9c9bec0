// A cell tree: a forest of binary trees (k-d trees) that halve the cells of a tensor grid, the root
// grid, along u or v. Its leaves are the cells of the mesh; vertices lie at dyadic points. Leaves
// of different sizes meet in hanging vertices, which become corners of the larger leaf's cell
// polygon. Source: H. Samet, "Foundations of Multidimensional and Metric Data Structures", 2006.
#pragma once

#include <cstdint>

#include "mesh/grid/grid.h"
#include "mesh/sizing/effort.h"
#include "mesh/tree/dyadic_vertices.h"
#include "mesh/tree/edge_table.h"
#include "mesh/tree/inner_vertices.h"
#include "mesh/tree/leaf.h"
#include "mesh/tree/revision_clock.h"
#include "mesh/tree/thin_vertices.h"
#include "mesh/tree/triangle_budget.h"
#include "mesh/tree/vertex_geometry.h"
#include "surface/parameter_box.h"

namespace saddle {

/// All that leaves share. The leaves themselves are kept by the mesher; positions and normals of
/// vertices are in the mesh of the root grid.
class CellTree {
 public:
  CellTree(const Surface& surface, Grid& grid, unsigned threads)
      : effort_(surface),
        revisions_(grid),
        vertices_(grid, revisions_),
        edges_(grid, vertices_, revisions_, effort_),
        geometry_(surface, grid, vertices_, revisions_, effort_, threads),
        budget_(vertices_, edges_, effort_) {}
  CellTree(const CellTree&) = delete;
  CellTree& operator=(const CellTree&) = delete;
  CellTree(CellTree&&) = delete;
  CellTree& operator=(CellTree&&) = delete;
  ~CellTree() = default;

  const Surface& surface() const { return geometry_.surface(); }
  const Mesh& mesh() const { return geometry_.mesh(); }

  /// Numbers and places of vertices.
  DyadicVertices& vertices() { return vertices_; }
  const DyadicVertices& vertices() const { return vertices_; }
  /// The surface at vertices.
  VertexGeometry& geometry() { return geometry_; }
  const VertexGeometry& geometry() const { return geometry_; }
  /// Features of sides.
  EdgeTable& edges() { return edges_; }
  const EdgeTable& edges() const { return edges_; }
  /// Vertices inside of leaves.
  InnerVertices& inner() { return inner_; }
  const InnerVertices& inner() const { return inner_; }
  /// Vertices in thin parts of sides.
  ThinVertices& thin() { return thin_; }
  const ThinVertices& thin() const { return thin_; }
  /// The work so far. Evaluations elsewhere for the same mesh are added to it.
  Effort& effort() { return effort_; }
  const Effort& effort() const { return effort_; }
  const TriangleBudget& budget() const { return budget_; }
  RevisionClock& revisions() { return revisions_; }
  const RevisionClock& revisions() const { return revisions_; }

  /// The box of a leaf's parameters.
  ParameterBox box(const Leaf& leaf) const {
    return {vertices_.parameters(leaf.low), vertices_.parameters(leaf.high())};
  }
  /// Whether the centre of a leaf is defined. It was where the sample is forgotten.
  bool is_centre_defined(const Leaf& leaf) const {
    return leaf.samples.centre == SampleVertices::kUnasked ||
           geometry_.is_defined(leaf.samples.centre);
  }
  /// Takes the middle of side k of a leaf into use.
  void use_middle(const Leaf& leaf, std::size_t k) {
    use_middle(leaf.samples.corner[k], leaf.samples.side[k], leaf.samples.corner[(k + 1) % 4]);
  }
  /// Takes the middle of a side between neighbours into use.
  void use_middle(std::uint32_t from, std::uint32_t middle, std::uint32_t to) {
    if (!vertices_.use_middle(from, middle, to)) return;
    edges_.discount_feature(from, to);
    edges_.pass_on(from, middle, to);
  }
  /// Whether the surface is known to go to infinity somewhere.
  bool has_poles() const { return edges_.has_poles() || geometry_.has_poles(); }

 private:
  Effort effort_;
  RevisionClock revisions_;
  DyadicVertices vertices_;
  EdgeTable edges_;
  InnerVertices inner_;
  ThinVertices thin_;
  VertexGeometry geometry_;
  TriangleBudget budget_;
};

/// Calls f(a, b) for neighbours a and b around the cell polygon of a leaf, hanging vertices
/// included, counter-clockwise in (u, v).
template <class F>
void for_sides(const Leaf& leaf, const CellTree& tree, F f) {
  const std::uint32_t first = leaf.samples.corner[0];
  std::uint32_t before = first;
  for (std::size_t k = 0; k < 4; ++k) {
    tree.vertices().walk(leaf, k, [&](std::uint32_t vertex, DyadicPoint) {
      if (vertex == first) return;
      f(before, vertex);
      before = vertex;
    });
  }
  f(before, first);
}

}  // namespace saddle
