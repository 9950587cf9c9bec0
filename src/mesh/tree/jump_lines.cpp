#include "mesh/tree/jump_lines.h"

#include <algorithm>
#include <array>
#include <optional>
#include <span>

#include <glm/geometric.hpp>

#include "mesh/tree/cell_tree.h"

namespace saddle {

JumpLines::JumpLines(const Leaf& leaf, const CellTree& tree) {
  bool are_jumps = true;
  std::size_t corner = 0;
  std::size_t side = 0;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto& corners = leaf.samples.corner;
    if (const auto feature = tree.edges().feature(a, b)) {
      are_jumps = are_jumps && feature->kind == FeatureKind::Jump;
      have_strips_ = have_strips_ || (feature->kind == FeatureKind::Jump && feature->strips > 0);
      feature->for_jumps(a, [&](std::uint32_t before, std::uint32_t after) {
        crossings_.push_back({before, after, corner, side});
      });
    }
    ++corner;
    if (side < 3 && b == corners[side + 1]) ++side;
  });
  if (!are_jumps || crossings_.size() < 4) return;
  join();
  if (!partners_.empty() && !is_plausible(tree)) partners_.clear();
}

/// Lines lie around the corners between the sides, the innermost next to its corner.
void JumpLines::join() {
  struct CrossedSide {
    std::size_t first, count;
  };
  std::vector<CrossedSide> sides;
  for (std::size_t k = 0; k < crossings_.size(); ++k) {
    if (sides.empty() || crossings_[k].side != crossings_[k - 1].side) sides.push_back({k, 0});
    ++sides.back().count;
  }
  if (sides.size() < 2 || sides.size() > 3) return;
  cross_two_sides_ = sides.size() == 2;
  sides.resize(3, {crossings_.size(), 0});
  const std::size_t lines = crossings_.size() / 2;
  const auto takes_too_many = [&](const CrossedSide& side) { return side.count > lines; };
  if (crossings_.size() % 2 == 1 || std::ranges::any_of(sides, takes_too_many)) return;
  partners_.resize(crossings_.size());
  for (std::size_t k = 0; k < 3; ++k) {
    const CrossedSide& side = sides[k];
    const CrossedSide& next = sides[(k + 1) % 3];
    // All lines but those that do not reach the third side.
    const std::size_t between = lines - sides[(k + 2) % 3].count;
    for (std::size_t i = 0; i < between; ++i) {
      const std::size_t last = side.first + side.count - 1 - i;
      partners_[last] = next.first + i;
      partners_[next.first + i] = last;
    }
  }
}

bool JumpLines::is_plausible(const CellTree& tree) const {
  const auto& position = tree.mesh().position;
  for (std::size_t k = 0; k < crossings_.size(); ++k) {
    const JumpCrossing& here = crossings_[k];
    const JumpCrossing& there = crossings_[partners_[k]];
    const dvec3 step = position[here.after] - position[here.before];
    const dvec3 step_there = position[there.before] - position[there.after];
    const double longer = std::max(glm::length(step), glm::length(step_there));
    // Where more lines than one cross in the leaf, sheets change places and steps turn.
    if (!(glm::distance(step, step_there) <= longer)) return false;
  }
  return true;
}

}  // namespace saddle
