#include "mesh/mesher/follow_features.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "mesh/mesher/edge_features.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/match_seams.h"

namespace saddle {

namespace {

/// Whether a side of a leaf has an edge feature other than a boundary.
bool is_crossed(const Leaf& leaf, const CellTree& tree) {
  bool is_crossed = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<EdgeFeature> feature = tree.edges().feature(a, b);
    is_crossed = is_crossed || (feature && !feature->is_boundary());
  });
  return is_crossed;
}

}  // namespace

std::vector<std::size_t> follow_features(const TraceOptions& options, std::span<Leaf> leaves,
                                         CellTree& tree) {
  std::vector<std::size_t> split;
  while (true) {
    std::vector<Side> sides;
    const std::uint32_t now = tree.revisions().next();
    for (std::size_t k = 0; k < leaves.size(); ++k) {
      Leaf& leaf = leaves[k];
      if (!tree.revisions().has_changed(leaf, leaf.followed_at)) continue;
      leaf.followed_at = now;
      LeafState& state = leaf.state;
      if (!state.is_cut_by_feature() && tree.edges().may_be_crossed(leaf) &&
          is_crossed(leaf, tree)) {
        state.set_features(true, count_features(leaf, tree).leads_to_pole);
        split.push_back(k);
      }
      if (state.is_whole()) continue;
      append_unsearched(leaf, tree, sides);
    }
    if (sides.empty() || tree.budget().is_spent(options.triangles)) return split;
    sort_sides(sides);
    trace_features(sides, options, tree);
  }
}

void trace_features_across_seams(const Seams& seams, const TraceOptions& options, const Grid& grid,
                                 CellTree& tree) {
  std::vector<Side> sides;
  for (const SeamSide& both : seam_sides_with_features(seams, grid, tree)) {
    const Side side = side_of(both.other[0], both.other[1]);
    if (!tree.edges().is_searched(side[0], side[1])) sides.push_back(side);
  }
  if (!sides.empty()) trace_features(sides, options, tree);
}

}  // namespace saddle
