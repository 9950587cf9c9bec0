#include "mesh/model/sides.h"

namespace saddle {

std::optional<std::uint32_t> apex_beyond(std::span<const Triangle> triangles, std::uint32_t a,
                                         std::uint32_t b) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == b) return t[(k + 2) % 3];
    }
  }
  return std::nullopt;
}

}  // namespace saddle
