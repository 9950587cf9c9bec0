// Sides of triangles.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "mesh/model/mesh.h"

namespace saddle {

/// The third corner of the triangle that runs from corner a to corner b.
std::optional<std::uint32_t> apex_beyond(std::span<const Triangle> triangles, std::uint32_t a,
                                         std::uint32_t b);

/// Whether a triangle runs from corner a to corner b.
inline bool has_side(std::span<const Triangle> triangles, std::uint32_t a, std::uint32_t b) {
  return apex_beyond(triangles, a, b).has_value();
}

/// The number of triangles from the first on that share corners with others before them; there is
/// one.
std::size_t count_connected(std::span<const Triangle> triangles);

/// Calls f(triangle, k, is_diagonal) for each side of triangles once: the one from the triangle's
/// corner k on. A diagonal is a side of two.
template <class F>
void for_triangle_sides(std::span<const Triangle> triangles, F f) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      const bool is_diagonal = has_side(triangles, b, a);
      if (a < b || !is_diagonal) f(t, k, is_diagonal);
    }
  }
}

}  // namespace saddle
