// The features on the sides of a leaf, counted: what cuts it, and along which direction.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "mesh/tree/edge_table.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Adds the point of the surface at a singular vertex, once.
void add_singular_vertex(std::uint32_t vertex, const CellTree& tree,
                         std::vector<std::uint32_t>& points);

/// Whether a strip between two jumps of a side, or a segment of a cliff, is wider than kClose of
/// the side.
bool is_wide_strip(const EdgeFeature& feature, std::size_t strip, const Side& side,
                   const CellTree& tree);

/// Whether a side of a leaf has a feature of this kind.
bool has_cut(FeatureKind kind, const Leaf& leaf, const CellTree& tree);

/// Whether a vertex of the cell polygon lies in a thin part of a side.
bool has_thin_vertex(const Leaf& leaf, const CellTree& tree);
/// Whether one of them is defined: a strip of the surface enters the leaf there.
bool has_thin_strip(const Leaf& leaf, const CellTree& tree);

/// The features and singular points around a leaf.
struct FeatureCount {
  std::size_t features = 0;
  /// Features on the two sides of constant u, and on those of constant v.
  std::size_t on_sides_of_u = 0, on_sides_of_v = 0;
  /// Features at corners of the leaf, from where a line goes along a side.
  std::size_t at_ends_of_u = 0, at_ends_of_v = 0;
  std::size_t at_vertices = 0;  ///< pairs of features at one vertex, on both of its sides
  std::size_t singular_points = 0;
  std::size_t creases = 0;     ///< among the features
  bool is_thin_strip = false;  ///< a thin strip enters the leaf, and `creases` is 1
  /// Whether the surface leaves the clip box through another face at the other end of a pole's
  /// line, as where v/u changes its sign, or the line ends in the leaf.
  bool changes_face = false;
  bool only_creases = true;  ///< among the features
  bool only_jumps = true;    ///< and creases and cliffs
  bool has_cliffs = false;
  bool is_continuous = true;   ///< there are no others than creases and cliffs
  bool has_more = false;       ///< a side has more than one, or strips that end in the leaf
  std::size_t lines = 0;       ///< of jumps that go through side by side, if more than one
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

  /// Whether the only crease ends in the leaf, beside a strip too thin for others: it parts
  /// nothing.
  bool is_crease_in_strip() const { return creases == 1 && is_thin_strip && !leads_to_pole; }

  /// Whether a line goes through the leaf, or several side by side, so that sub_polygons() yields
  /// one more. A vertex on a jump may have a value of its own, as sign(0) is 0: the line then cuts
  /// both sides that meet there.
  bool is_through() const {
    if (has_more || changes_face) return false;
    return lines > 0 || features == 2 || features - at_vertices == 2 ||
           (only_creases && features < 2 && features + singular_points == 2);
  }
};
/// Whether a whole side may be singular: its ends are, and are different points.
bool is_cusp(std::uint32_t a, std::uint32_t b, const CellTree& tree);
/// Whether the features and cusps of a leaf extend along u rather than along v, relative to its
/// sides. Without any: whether u is its longer direction.
bool is_cut_along_u(const Leaf& leaf, const CellTree& tree);

/// The sides of a leaf on which a sheet of its neighbour ends: the surface jumps on the side
/// itself. From end to end, counter-clockwise.
std::vector<std::array<std::uint32_t, 2>> sides_along_jumps(const Leaf& leaf, const CellTree& tree);

FeatureCount count_features(const Leaf& leaf, const CellTree& tree);

}  // namespace saddle
