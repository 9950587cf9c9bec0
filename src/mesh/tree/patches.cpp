#include "mesh/tree/patches.h"

#include <array>

#include "mesh/tree/cell_polygon.h"

namespace saddle {
namespace {

/// The gap reason of the last feature on the sides of a leaf that is no boundary and no crease.
/// Without one: Boundary or Crease, by the state of the leaf.
GapReason worst_feature(const Leaf& leaf, const CellTree& tree) {
  constexpr std::array kReasonOfFeature = {GapReason::Boundary, GapReason::Jump,
                                           GapReason::Pole,     GapReason::Crease,
                                           GapReason::NoLimit,  GapReason::Pole};
  GapReason worst = leaf.state.is_on_boundary() ? GapReason::Boundary : GapReason::Crease;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature || feature->kind == FeatureKind::Boundary || feature->kind == FeatureKind::Crease)
      return;
    worst = kReasonOfFeature[static_cast<std::size_t>(feature->kind)];
  });
  return worst;
}

}  // namespace

Patch patch_of(const Leaf& leaf, double allowed, const Grid& grid, const CellTree& tree) {
  Patch patch = {{tree.vertices().parameters(leaf.low), tree.vertices().parameters(leaf.high)},
                 allowed,
                 grid.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit),
                 {}};
  // Its waves are too short for any mesh.
  if (leaf.state.oscillates()) patch.cut_by = GapReason::Wide;
  if (leaf.state.is_whole()) return patch;
  patch.cut_by = worst_feature(leaf, tree);
  // The surface is continuous across a crease: measured distances prove it.
  patch.is_measured = patch.cut_by == GapReason::Crease;
  if (patch.is_measured) patch.cut_by.reset();
  return patch;
}

}  // namespace saddle
