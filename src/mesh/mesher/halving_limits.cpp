#include "mesh/mesher/halving_limits.h"

#include <cmath>

#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Halvings that follow a boundary, at most: 24 reach a corner of two boundaries with vertical
/// tangents; a point where a jump ends at such a boundary takes all there are. Boundaries that meet
/// at a pole or a clip face end at kMostCutHalvings.
constexpr int kMostBoundaryHalvings = 24;

}  // namespace

int most_boundary_halvings(const Leaf& leaf, const CellTree& tree) {
  const bool goes_far =
      has_cut(FeatureKind::Pole, leaf, tree) || has_cut(FeatureKind::Face, leaf, tree);
  if (goes_far) return kMostCutHalvings;
  return leaf.state.is_cut_by_feature() ? kMostHalvings : kMostBoundaryHalvings;
}

int boundary_halvings(const Leaf& leaf, const CellTree& tree) {
  const int wanted = kBoundaryHalvings + std::ilogb(leaf.safety);
  return wanted <= kMostCutHalvings ? wanted : std::min(wanted, most_boundary_halvings(leaf, tree));
}

int wanted_halvings(const FeatureCount& features) {
  if (features.is_crease_in_strip()) return 0;
  if (!features.is_through() &&
      (features.only_creases || features.leads_to_pole || !features.only_jumps)) {
    return kMostCutHalvings;
  }
  // A leaf with a pole is cut like one with a boundary. Lines that cross may be solved for.
  return features.leads_to_pole || !features.is_through() ? kBoundaryHalvings : 0;
}

bool is_search_due(const Leaf& leaf) {
  const auto is_due = [](std::uint8_t stagnation) {
    return stagnation > 0 && stagnation % kInVain == 0;
  };
  return leaf.state.is_cut_by_feature() || is_due(leaf.stagnation) ||
         is_due(leaf.normal_stagnation);
}

}  // namespace saddle
