// Cell polygons: the vertices around a leaf, and the sub-polygons into which boundaries, jumps and
// creases cut it.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "mesh/tree/cell_tree.h"
#include "mesh/tree/polygon.h"

namespace saddle {

using Polygon = std::vector<PolygonCorner>;

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

/// The number of vertices of the cell polygon.
std::uint32_t count_polygon_vertices(const Leaf& leaf, const CellTree& tree);

/// The positions of a leaf's corners, counter-clockwise in (u, v).
std::array<dvec3, 4> corner_positions(const Leaf& leaf, const CellTree& tree);

/// The sides of the cell polygon.
std::vector<Side> sides_of(const Leaf& leaf, const CellTree& tree);

/// The corners of a leaf that nothing cuts and that has no hanging vertices; else nothing.
std::optional<std::array<std::uint32_t, 4>> plain_corners(const Leaf& leaf, const CellTree& tree);

/// The parts of a leaf that the mesh covers: the whole cell polygon, or those into which features
/// cut it. Parts that are undefined or go to infinity are left out, and a leaf in which a jump
/// ends.
std::vector<Polygon> sub_polygons(const Leaf& leaf, const CellTree& tree);

/// Whether an edge of a sub-polygon is a chord of a feature, not a part of the leaf's border.
/// `middle`: its middle, in the unit square of the leaf.
bool is_chord(const dvec2& middle, const Side& edge, const CellTree& tree);

/// Whether a sub-polygon is a side of its leaf, within rounding: a crease runs along the side, and
/// neighbours have vertices on it.
bool is_flat(const Polygon& sub_polygon);

/// Whether the flat sub-polygon of a leaf lies along u; nothing if no sub-polygon is flat.
std::optional<bool> flat_sub_polygon_along_u(const Leaf& leaf, const CellTree& tree);

/// Whether a side of a leaf has a feature of this kind.
bool has_cut(FeatureKind kind, const Leaf& leaf, const CellTree& tree);

/// The features and singular points around a leaf.
struct FeatureCount {
  std::size_t features = 0;
  /// Features on the two sides of constant u, and on those of constant v.
  std::size_t on_sides_of_u = 0, on_sides_of_v = 0;
  /// Features at corners of the leaf, from where a line goes along a side.
  std::size_t at_ends_of_u = 0, at_ends_of_v = 0;
  std::size_t at_vertices = 0;  ///< pairs of features at one vertex, on both of its sides
  std::size_t singular_points = 0;
  bool only_creases = true;    ///< among the features
  bool only_jumps = true;      ///< and creases
  bool has_more = false;       ///< a side has more than one
  bool leads_to_pole = false;  ///< a side does

  /// The direction that separates several lines which cut a leaf: lines that cross its sides of
  /// constant u are separated along v. Where a line ends in the leaf, the longer direction.
  bool is_parted_along_u(const Leaf& leaf) const {
    if (features <= 2 || on_sides_of_u == on_sides_of_v || meets_line_along_side()) {
      return leaf.size_u() >= leaf.size_v();
    }
    return on_sides_of_v > on_sides_of_u;
  }

  /// Whether a line goes along a side, and others start from it.
  bool meets_line_along_side() const {
    const std::size_t inner_u = on_sides_of_u - at_ends_of_u;
    const std::size_t inner_v = on_sides_of_v - at_ends_of_v;
    return (at_ends_of_u > 0 && inner_u == 0 && inner_v > 0) ||
           (at_ends_of_v > 0 && inner_v == 0 && inner_u > 0);
  }

  /// Whether one line goes through the leaf, so that sub_polygons() yields two. A vertex on a jump
  /// may have a value of its own, as sign(0) is 0: the line then cuts both sides that meet there.
  bool is_through() const {
    if (has_more) return false;
    return features == 2 || features - at_vertices == 2 ||
           (only_creases && features < 2 && features + singular_points == 2);
  }
};
/// Whether a whole side may be singular: its ends are, and are different points.
bool is_cusp(std::uint32_t a, std::uint32_t b, const CellTree& tree);
/// Whether the features and cusps of a leaf extend along u rather than along v, relative to its
/// sides. Without any: whether u is its longer direction.
bool is_cut_along_u(const Leaf& leaf, const CellTree& tree);

FeatureCount count_features(const Leaf& leaf, const CellTree& tree);

}  // namespace saddle
