#include "mesh/model/point_union.h"

#include <algorithm>

namespace saddle {

void PointUnion::unite(std::size_t a, std::size_t b) {
  const std::uint32_t root_a = find(static_cast<std::uint32_t>(a));
  const std::uint32_t root_b = find(static_cast<std::uint32_t>(b));
  if (root_a == root_b) return;
  const auto [first, other] = std::minmax(root_a, root_b);
  mesh_.point[other] = first;
  if (other < oldest_new_) others_.push_back(other);
  grown_.push_back(first);
  is_settled_ = false;
}

void PointUnion::settle() {
  if (is_settled_) return;
  for (; oldest_new_ < mesh_.point.size(); ++oldest_new_) {
    if (mesh_.point[oldest_new_] != oldest_new_) others_.push_back(oldest_new_);
  }
  for (const std::uint32_t corner : others_) {
    const std::uint32_t first = find(corner);
    mesh_.point[corner] = first;
    mesh_.position[corner] = mesh_.position[first];
  }
  is_settled_ = true;
}

std::vector<std::uint32_t> PointUnion::take_changed() {
  for (std::uint32_t& corner : grown_) corner = mesh_.point[corner];
  std::ranges::sort(grown_);
  std::vector<std::uint32_t> changed;
  for (const std::uint32_t corner : others_) {
    if (std::ranges::binary_search(grown_, mesh_.point[corner])) changed.push_back(corner);
  }
  grown_.clear();
  return changed;
}

std::uint32_t PointUnion::find(std::uint32_t corner) {
  auto& point = mesh_.point;
  while (point[corner] != corner) corner = point[corner] = point[point[corner]];
  return corner;
}

}  // namespace saddle
