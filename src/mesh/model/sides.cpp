#include "mesh/model/sides.h"

#include <algorithm>

namespace saddle {

namespace {

bool share_corner(const Triangle& a, const Triangle& b) {
  return std::ranges::any_of(
      a, [&](std::uint32_t corner) { return std::ranges::find(b, corner) != b.end(); });
}

}  // namespace

std::optional<std::uint32_t> apex_beyond(std::span<const Triangle> triangles, std::uint32_t a,
                                         std::uint32_t b) {
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] == a && t[(k + 1) % 3] == b) return t[(k + 2) % 3];
    }
  }
  return std::nullopt;
}

std::size_t count_connected(std::span<const Triangle> triangles) {
  std::size_t count = 1;
  // Most triangles have a corner of the one before: a thousand take a thousand looks so, not half a
  // million.
  const auto is_connected = [&](const Triangle& t) {
    const auto before = triangles.first(count);
    return std::any_of(before.rbegin(), before.rend(),
                       [&](const Triangle& other) { return share_corner(t, other); });
  };
  while (count < triangles.size() && is_connected(triangles[count])) ++count;
  return count;
}

}  // namespace saddle
