// The vertices around a leaf, and the polygons that rims, jumps and creases cut it into.
#pragma once

#include <array>
#include <vector>

#include "mesh/lattice.h"
#include "mesh/polygon.h"

namespace saddle {

using Polygon = std::vector<PolygonCorner>;

/// Two neighbours among the vertices in use around a leaf, the one with the smaller number first.
using Side = std::array<std::uint32_t, 2>;

/// The sides of a leaf, with all the vertices in use on them.
std::vector<Side> sides_of(const Leaf& leaf, const Lattice& lattice);

/// What of a leaf the mesh covers: the whole outline, or what its crossings cut it into. Left out
/// is what is undefined, goes to infinity, or has a jump that ends inside of the leaf.
std::vector<Polygon> pieces(const Leaf& leaf, const Lattice& lattice);

/// What may cut a leaf.
struct CutCount {
  std::size_t crossings = 0;
  std::size_t singular_points = 0;
  bool only_creases = true;  ///< of the crossings

  /// Whether pieces() cuts a leaf that is split into two.
  bool is_through() const {
    return crossings == 2 || (only_creases && crossings < 2 && crossings + singular_points == 2);
  }
};
CutCount count_cuts(const Leaf& leaf, const Lattice& lattice);

}  // namespace saddle
