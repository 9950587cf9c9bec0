// The triangles of a page in an order in which each one is told by its neighbour: about three bits
// of a deflated file each. src/export/page/payload.js follows the same steps.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/model/mesh.h"

namespace saddle {

/// Triangles and corners in the order of a walk over the mesh, from each triangle to those beside
/// it, the latest first.
struct PageTriangles {
  /// Said at each step, of the corner that a triangle adds to the side that it was reached by, or
  /// of each corner of a triangle that none led to.
  enum Code : std::uint32_t {
    kNothing,  ///< no triangle on the other side
    kNew,      ///< the next corner
    kBehind,   ///< the corner from which the border of the triangles so far comes to the side
    kOld       ///< and larger: that many corners before the next one, but for kOld
  };
  /// The corners from which a new one is told: it is near a + b - c. All three are the corner
  /// before, where no triangle says more.
  using Guess = std::array<std::uint32_t, 3>;

  std::vector<std::uint32_t> codes;
  std::vector<std::uint32_t> corners;  ///< of the mesh, in their new order
  std::vector<Guess> guesses;          ///< of each corner but the first, by new numbers
  std::vector<std::uint32_t> place;    ///< of each corner of the mesh in the new order
};

/// Corners that lines alone have follow those of triangles.
PageTriangles page_triangles(const Mesh& mesh);

}  // namespace saddle
