// Chords of leaves that lie on each other, where a surface meets itself.
#pragma once

#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// Where more than two triangles meet in an edge and two of them are of one leaf, cuts the two
/// along their other diagonal, if that is free: around the end of a folded edge, and around a pole
/// that many lines come together in, chords of different leaves may join the same two points.
void flip_shared_chords(const Grid& grid, LeafTriangles& triangles);

}  // namespace saddle
