// A leaf of a refined grid, with all the vertices on its sides, into triangles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mesh/tree/cell_tree.h"

namespace saddle {

/// A corner of the mesh and where it is in the leaf.
struct PolygonCorner {
  std::uint32_t corner;
  dvec2 place;  ///< in units of the cell tree
};

/// By how much the place of a cut may be off a straight side that it is on, in units of the
/// cell tree: it is mixed from those of the side's ends, which are exact.
inline double rounding_of_place(const dvec2& place) {
  return 4 * std::numeric_limits<double>::epsilon() *
         std::max(std::fabs(place.x), std::fabs(place.y));
}

/// Triangulates a convex polygon, counter-clockwise in (u, v), whose corners may lie on straight
/// sides: ears are cut off one by one, the one with the smallest sagitta of its chord first, each
/// of positive area in (u, v). Triangles without area in space are left out. Appends to
/// `triangles`, counter-clockwise seen from the front.
void triangulate_polygon(const Grid& grid, std::vector<PolygonCorner> polygon,
                         Array<Triangle>& triangles);

}  // namespace saddle
