#include "mesh/mesher/follow_features.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/parallel.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/match_seams.h"

namespace saddle {

namespace {

/// Sets the state of a leaf by the features of its sides. Returns whether it changed.
bool set_state(Leaf& leaf, const CellTree& tree) {
  LeafState& state = leaf.state;
  if (state.is_cut_by_feature() || !tree.edges().may_be_crossed(leaf)) return false;
  bool is_crossed = false;
  bool has_boundary = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<EdgeFeature> feature = tree.edges().feature(a, b);
    is_crossed = is_crossed || tree.edges().has_more(a, b);
    if (!feature) return;
    (feature->is_boundary() ? has_boundary : is_crossed) = true;
  });
  const bool is_new = is_crossed || (has_boundary && state.is_whole());
  if (is_crossed) state.set_features(true, count_features(leaf, tree).leads_to_pole);
  // Samples show no boundary that comes in only between them, at a hanging vertex.
  if (has_boundary && state.is_whole()) state.cross_boundary();
  return is_new;
}

/// The findings at leaves that one thread looks at.
struct Followed {
  std::vector<std::size_t> split;  ///< leaves whose state changed
  std::vector<Side> unsearched;    ///< sides of leaves that are not whole
};

}  // namespace

std::vector<std::size_t> follow_features(const TraceOptions& options, std::span<Leaf> leaves,
                                         CellTree& tree) {
  std::vector<std::size_t> split;
  while (true) {
    const std::uint32_t now = tree.revisions().next();
    const std::vector<Followed> parts = results_of_chunks(
        leaves.size(), kInBatch, options.threads, [&](std::size_t begin, std::size_t end) {
          Followed part;
          for (std::size_t k = begin; k < end; ++k) {
            Leaf& leaf = leaves[k];
            if (!tree.revisions().has_changed(leaf, leaf.followed_at)) continue;
            leaf.followed_at = now;
            if (set_state(leaf, tree)) part.split.push_back(k);
            if (!leaf.state.is_whole()) append_unsearched(leaf, tree, part.unsearched);
          }
          return part;
        });
    std::vector<Side> sides;
    for (const Followed& part : parts) {
      split.insert(split.end(), part.split.begin(), part.split.end());
      sides.insert(sides.end(), part.unsearched.begin(), part.unsearched.end());
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
