// Seam matching on the cell tree: vertices that are one point of the surface, at seams, at poles,
// and where a crease is a single point.
#pragma once

#include <span>
#include <vector>

#include "mesh/grid/weld.h"
#include "mesh/model/point_union.h"
#include "mesh/tree/edge_table.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;

/// Takes the partners of newly used vertices across seams into use, and makes both one point.
/// Vertices of the root grid are welded before.
void mirror_seams(const Seams& seams, unsigned threads, const Grid& grid, CellTree& tree,
                  PointUnion& points);

/// A side on a seam, and its partner.
struct SeamSide {
  Side side;
  Side other;  ///< other[k] is the partner of side[k]: not ordered by number
};

/// The sides on seams that carry a feature.
std::vector<SeamSide> seam_sides_with_features(const Seams& seams, const Grid& grid,
                                               const CellTree& tree);

/// Makes vertices beside features one point with their partners across seams.
void join_features(const Seams& seams, const Grid& grid, const CellTree& tree, PointUnion& points);

/// Makes neighbours at the same position one singular point. On sides of leaves these are poles
/// that no line of the root grid meets; on sub-polygons, apexes as of a double cone. Poles at
/// the same position become one point, as where all lines of radius 0 meet. Returns whether leaves
/// may have chords in common there: poles were joined, or one extends along both u and v.
bool join_poles(std::span<const Leaf> leaves, unsigned threads, const Grid& grid, CellTree& tree,
                PointUnion& points);

}  // namespace saddle
