// Detects seams: which edges of the domain join, from a few places on each.
#pragma once

#include "mesh/model/seam.h"
#include "surface/surface.h"

namespace saddle {

/// `diagonal`: of a box around the surface, in its units. An edge that is a point is not folded.
Seams find_seams(const Surface& surface, double diagonal);

}  // namespace saddle
