// The vertices around a leaf, and the polygons that boundaries, jumps and creases cut it into.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "mesh/tree/cell_tree.h"
#include "mesh/tree/polygon.h"

namespace saddle {

using Polygon = std::vector<PolygonCorner>;

/// Two neighbours among the vertices in use around a leaf, the one with the smaller number first.
using Side = std::array<std::uint32_t, 2>;

/// Calls f(a, b) for the neighbours a and b on the sides of a leaf, with all the vertices in use on
/// them, counter-clockwise in (u, v).
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

/// How many vertices in use are around a leaf.
std::uint32_t count_polygon_vertices(const Leaf& leaf, const CellTree& tree);

/// The positions of a leaf's corners, counter-clockwise in (u, v).
std::array<dvec3, 4> corner_positions(const Leaf& leaf, const CellTree& tree);

/// The sides of a leaf as pairs.
std::vector<Side> sides_of(const Leaf& leaf, const CellTree& tree);

/// The corners of a leaf that is cut by nothing and has no other vertices on its sides.
std::optional<std::array<std::uint32_t, 4>> plain_corners(const Leaf& leaf, const CellTree& tree);

/// What of a leaf the mesh covers: the whole outline, or what its crossings cut it into. Left out
/// is what is undefined, goes to infinity, or has a jump that ends inside of the leaf.
std::vector<Polygon> sub_polygons(const Leaf& leaf, const CellTree& tree);

/// Whether a piece is a side of its leaf, but for rounding: a crease goes along it, on which
/// neighbours have vertices.
bool is_flat(const Polygon& sub_polygon);

/// Whether the flat piece of a leaf, if there is one, is a side along u.
std::optional<bool> flat_sub_polygon_along_u(const Leaf& leaf, const CellTree& tree);

/// Whether a side of the leaf is cut like this.
bool has_cut(FeatureKind kind, const Leaf& leaf, const CellTree& tree);

/// What may cut a leaf.
struct FeatureCount {
  std::size_t features = 0;
  /// Crossings on the two sides of constant u, and on those of constant v.
  std::size_t on_sides_of_u = 0, on_sides_of_v = 0;
  /// Those of them that are at corners of the leaf: a line goes along the side from there.
  std::size_t at_ends_of_u = 0, at_ends_of_v = 0;
  std::size_t at_vertices = 0;  ///< pairs of them, on either side of a vertex and in its place
  std::size_t singular_points = 0;
  bool only_creases = true;    ///< of the crossings
  bool leads_to_pole = false;  ///< across a side

  /// Which way to halve a leaf that more than one line cuts: lines that cross its sides of constant
  /// u are parted along v. One that ends in it may do so anywhere, as on a line along a side.
  bool is_parted_across_u(const Leaf& leaf) const {
    if (features <= 2 || on_sides_of_u == on_sides_of_v || meets_line_along_side()) {
      return leaf.size_u() >= leaf.size_v();
    }
    return on_sides_of_v > on_sides_of_u;
  }

  /// Whether a line goes along a side, and others come from there.
  bool meets_line_along_side() const {
    const std::size_t inner_u = on_sides_of_u - at_ends_of_u;
    const std::size_t inner_v = on_sides_of_v - at_ends_of_v;
    return (at_ends_of_u > 0 && inner_u == 0 && inner_v > 0) ||
           (at_ends_of_v > 0 && inner_v == 0 && inner_u > 0);
  }

  /// Whether pieces() cuts a leaf that is split into two. A vertex on a jump may have a value of
  /// its own, as sign(0) is 0: both sides that meet there are then cut by the line that goes
  /// through it.
  bool is_through() const {
    return features == 2 || features - at_vertices == 2 ||
           (only_creases && features < 2 && features + singular_points == 2);
  }
};
/// Whether all of a side between neighbours may be singular without being one point.
bool is_cusp(std::uint32_t a, std::uint32_t b, const CellTree& tree);
/// Whether what cuts a leaf, or goes along its sides, goes along u rather than along v, in sides of
/// the leaf, or the leaf itself does.
bool is_cut_along_u(const Leaf& leaf, const CellTree& tree);

FeatureCount count_features(const Leaf& leaf, const CellTree& tree);

}  // namespace saddle
