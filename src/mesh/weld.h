// Poles and seams: which vertices of a grid are the same point of the surface.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mesh/grid.h"

namespace saddle {

struct Joints {
  std::vector<std::uint32_t> point;  ///< per vertex: the first vertex that is the same point
  std::string closed_u;              ///< how the edges u0 and u1 meet: "", "join" or "reversed"
  std::string closed_v;
};

/// Finds lines of the grid that are one point of the surface, and opposite edges that meet. Makes
/// the positions of vertices that are one point bitwise equal; at a seam they become those of the
/// edge u0 or v0.
Joints weld(Grid& grid);

}  // namespace saddle
