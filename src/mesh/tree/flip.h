// Coinciding chords of different leaves, where a surface meets itself.
#pragma once

#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// Flips the diagonal of two triangles of a leaf if more than two triangles meet in it and the
/// other diagonal is free. Chords of different leaves join the same two points around the end of a
/// folded edge, and around a pole at which many lines meet.
void flip_shared_chords(const Grid& grid, LeafTriangles& triangles);

}  // namespace saddle
