#include "mesh/proof/box_groups.h"

#include <algorithm>
#include <numeric>

#include <glm/common.hpp>

namespace saddle {

namespace {

bool touch(const ParameterBox& a, const ParameterBox& b) {
  const dvec2 gap = glm::max(glm::min(a.low, a.high) - glm::max(b.low, b.high),
                             glm::min(b.low, b.high) - glm::max(a.low, a.high));
  return std::max(gap.x, gap.y) <= 0;
}

}  // namespace

std::vector<std::uint32_t> groups_of(std::span<const ParameterBox> boxes) {
  std::vector<std::uint32_t> first(boxes.size());
  std::iota(first.begin(), first.end(), 0U);
  const auto root = [&](std::uint32_t k) {
    while (first[k] != k) k = first[k] = first[first[k]];
    return k;
  };
  std::vector<std::uint32_t> by_u = first;
  const auto left = [&](std::uint32_t k) { return std::min(boxes[k].low.x, boxes[k].high.x); };
  const auto right = [&](std::uint32_t k) { return std::max(boxes[k].low.x, boxes[k].high.x); };
  std::ranges::stable_sort(by_u, {}, left);
  for (std::size_t i = 0; i < by_u.size(); ++i) {
    for (std::size_t j = i + 1; j < by_u.size() && left(by_u[j]) <= right(by_u[i]); ++j) {
      if (!touch(boxes[by_u[i]], boxes[by_u[j]])) continue;
      const auto [low, high] = std::minmax({root(by_u[i]), root(by_u[j])});
      first[high] = low;
    }
  }
  for (std::uint32_t k = 0; k < first.size(); ++k) first[k] = root(k);
  return first;
}

}  // namespace saddle
