// Which sides of a mesh's triangles are joined, two at a time, whatever lies between the same two
// points: what is made along joined sides is a surface in which no edge has three triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// across[3 t + k] is the side that the side of triangle t from its corner k to the next is joined
/// with, numbered in the same way; kNoIndex: none, it is a border.
struct JoinedSides {
  Array<std::uint32_t> across;
  /// Sides that are not the only edge between their points: all but the first one's.
  std::vector<std::uint32_t> doubled;
};

/// Sides that are the only two between their points are joined. Among more, those with the same
/// corners are, then those that go on most nearly straight; what is left over is a border. No
/// triangle may have two corners at one point.
JoinedSides join_sides(const Mesh& mesh);

/// A triangle has two corners at one point.
bool has_flat_triangles(const Mesh& mesh);

/// The mesh without triangles that have two corners at one point.
Mesh without_flat_triangles(Mesh mesh);

/// The mesh with a point of its own in the middle of each of the doubled sides: joined sides are
/// then the only ones between their points. Lines and contours stay.
Mesh with_single_edges(Mesh mesh, const JoinedSides& joined);

}  // namespace saddle
