#include "mesh/tree/patches.h"

#include <algorithm>
#include <array>
#include <optional>

#include "mesh/tree/cell_polygon.h"

namespace saddle {
namespace {

/// The gap reason of the last feature on the sides of a leaf that is no boundary and no crease.
/// Without one: Boundary or Crease, by the state of the leaf.
GapReason worst_feature(const Leaf& leaf, const CellTree& tree) {
  constexpr std::array kReasonOfFeature = {GapReason::Boundary, GapReason::Jump,    GapReason::Pole,
                                           GapReason::Crease,   GapReason::NoLimit, GapReason::Pole,
                                           GapReason::Crease};
  GapReason worst = leaf.state.is_on_boundary() ? GapReason::Boundary : GapReason::Crease;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature || feature->kind == FeatureKind::Boundary || feature->is_continuous()) return;
    worst = kReasonOfFeature[static_cast<std::size_t>(feature->kind)];
  });
  return worst;
}

/// The line of constant u or v along which a leaf jumps, if nothing else cuts it.
std::optional<JumpLine> jump_line_of(const Leaf& leaf, const Grid& grid, const CellTree& tree) {
  std::optional<JumpLine> line;
  bool is_one = true;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature) return;
    const dvec2& first = grid.mesh.uv[feature->beside_first];
    const dvec2& second = grid.mesh.uv[feature->beside_second];
    const int axis = first.x == second.x ? 1 : 0;
    const auto [below, above] = std::minmax(first[axis], second[axis]);
    const bool may_jump =
        feature->kind == FeatureKind::Jump || feature->kind == FeatureKind::Crease;
    is_one = is_one && may_jump && feature->strips == 0 && first[1 - axis] == second[1 - axis] &&
             (!line || line->axis == axis);
    if (!line) line = {axis, below, above};
    line->below = std::min(line->below, below);
    line->above = std::max(line->above, above);
  });
  return is_one ? line : std::nullopt;
}

}  // namespace

std::size_t root_cell_of(const Leaf& leaf, const Grid& grid) {
  return grid.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit);
}

Patch patch_of(const Leaf& leaf, double allowed, const Grid& grid, const CellTree& tree) {
  Patch patch = {tree.box(leaf), allowed, {}};
  // Its waves are too short for any mesh.
  if (leaf.state.oscillates()) patch.cut_by = GapReason::Wide;
  if (leaf.state.is_whole()) return patch;
  patch.cut_by = worst_feature(leaf, tree);
  // The surface is continuous across a crease: measured distances prove it.
  patch.is_measured = patch.cut_by == GapReason::Crease;
  if (patch.is_measured) patch.cut_by.reset();
  if (patch.cut_by == GapReason::Jump) patch.jump_line = jump_line_of(leaf, grid, tree);
  return patch;
}

}  // namespace saddle
