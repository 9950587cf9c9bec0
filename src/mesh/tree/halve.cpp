#include "mesh/tree/halve.h"

#include "mesh/grid/grid.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

bool has_defined_corner(const Leaf& leaf, const CellTree& tree) {
  bool has = false;
  for_sides(leaf, tree,
            [&](std::uint32_t a, std::uint32_t) { has = has || tree.geometry().is_defined(a); });
  return has;
}

std::vector<Leaf> root_leaves(const Grid& grid, std::size_t first, std::size_t end) {
  std::vector<Leaf> leaves;
  leaves.reserve(end - first);
  for (std::size_t cell = first; cell < end; ++cell) {
    const auto i = static_cast<std::uint32_t>(cell % grid.cells_u);
    const auto j = static_cast<std::uint32_t>(cell / grid.cells_u);
    leaves.push_back({{i * kCellUnit, j * kCellUnit}});
  }
  return leaves;
}

std::optional<std::array<Leaf, 2>> halve(const Leaf& leaf, bool along_u, CellTree& tree) {
  if ((along_u ? leaf.size_u() : leaf.size_v()) < 2) return std::nullopt;
  const DyadicPoint middle = leaf.middle();
  std::array<Leaf, 2> halves = {leaf, leaf};
  for (Leaf& half : halves) half.followed_at = 0;
  halves[0].samples = leaf.samples.of_half(along_u, true);
  halves[1].samples = leaf.samples.of_half(along_u, false);
  for (Leaf& half : halves) ++(along_u ? half.halved_u : half.halved_v);
  (along_u ? halves[1].low.u : halves[1].low.v) = along_u ? middle.u : middle.v;
  const std::size_t first = along_u ? 0 : 1;
  for (const std::size_t k : {first, first + 2}) tree.use_middle(leaf, k);
  return halves;
}

}  // namespace saddle
