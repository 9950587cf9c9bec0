// Sides of triangles.
#pragma once

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

}  // namespace saddle
