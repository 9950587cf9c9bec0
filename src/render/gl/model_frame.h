// The coordinates in which a mesh is on the GPU.
#pragma once

#include "base/bounds.h"
#include "base/vec.h"

namespace saddle {

/// Model coordinates are (world - centre) / sides, computed in double: floats near 1 keep their 24
/// bits for the surface's shape, wherever it is and however large.
struct ModelFrame {
  dvec3 centre{0, 0, 0};
  double size = 1;
  /// All of them `size`, but of a mesh that is much shorter along one axis than along another: a
  /// picture may be stretched until all are alike. Normals are those of the stretched mesh, too.
  dvec3 sides{1, 1, 1};
};

/// The frame in which `bounds` lies within distance 1 of the origin.
ModelFrame model_frame(const Bounds& bounds);

}  // namespace saddle
