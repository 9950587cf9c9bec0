// Vertices of a refined grid that are one point of the surface: at seams, at poles, and where a
// crease is a single point.
#pragma once

#include <span>
#include <vector>

#include "mesh/grid/weld.h"
#include "mesh/model/point_union.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

/// Puts the vertices in use on one side of each seam into use on the other, and makes both one
/// point. Root vertices are welded already.
void mirror_seams(const Seams& seams, unsigned threads, const Grid& grid, CellTree& tree,
                  PointUnion& points);

/// The ends of a side on a seam, and their partners.
struct SeamSide {
  Side side;
  Side other;  ///< not in order: other[k] is the partner of side[k]
};

/// The sides on seams that carry a feature.
std::vector<SeamSide> seam_sides_with_features(const Seams& seams, const Grid& grid,
                                               const CellTree& tree);

/// Makes the vertices beside cuts one point with those on the other side of a seam.
void join_features(const Seams& seams, const Grid& grid, const CellTree& tree, PointUnion& points);

/// Makes neighbours on the sides of leaves that are at the same place one singular point, as at
/// poles that no line of the root grid goes through, and neighbours on a cut as well, as at the
/// apex of a double cone. Poles at the same place become one point, as where all of the lines on
/// which a radius is 0 come together. Returns whether leaves may have chords in common there: some
/// became one, or one is more than a line of constant u or v.
bool join_poles(std::span<const Leaf> leaves, unsigned threads, const Grid& grid, CellTree& tree,
                PointUnion& points);

}  // namespace saddle
