#include "mesh/points.h"

#include <algorithm>

namespace saddle {

void Points::unite(std::size_t a, std::size_t b) {
  const std::uint32_t root_a = find(static_cast<std::uint32_t>(a));
  const std::uint32_t root_b = find(static_cast<std::uint32_t>(b));
  mesh_.point[std::max(root_a, root_b)] = std::min(root_a, root_b);
  is_settled_ = is_settled_ && root_a == root_b;
}

void Points::settle() {
  if (is_settled_) return;
  for (std::uint32_t corner = 0; corner < mesh_.point.size(); ++corner) {
    const std::uint32_t first = find(corner);
    if (first == corner) continue;
    mesh_.point[corner] = first;
    mesh_.position[corner] = mesh_.position[first];
  }
  is_settled_ = true;
}

std::uint32_t Points::find(std::uint32_t corner) {
  auto& point = mesh_.point;
  while (point[corner] != corner) corner = point[corner] = point[point[corner]];
  return corner;
}

}  // namespace saddle
