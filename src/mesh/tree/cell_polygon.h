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

}  // namespace saddle
