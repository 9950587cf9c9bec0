// From which to which number the colours of a mesh run.
#pragma once

#include <span>

#include "mesh/mesh.h"
#include "surface/surface.h"

namespace saddle {

struct DrawnColors {
  ColorRange range;
  bool is_clamped = false;  ///< the numbers go to infinity
};

/// The range of the numbers that the mesh's corners have. Toward an end at which they go to
/// infinity it stops where nine tenths of the area are inside. Where nine tenths of the area differ
/// by no more than `rounding`, or all of it by no more than doubles do, it is a single number.
DrawnColors drawn_colors(const Surface& surface, const Mesh& mesh, double rounding);

}  // namespace saddle
