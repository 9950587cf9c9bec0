#include "mesh/mesher/split_direction.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/mesher/oscillation.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/leaf_border.h"

namespace saddle {

namespace {

/// An error estimate below 0.5 tolerances says nothing about the direction of a sampled error.
constexpr double kSignificant = 0.5;

/// Whether a leaf is slender beside its root cell.
bool is_sliver(const Leaf& leaf) {
  return kSlender * std::min(leaf.size_u(), leaf.size_v()) <= kCellUnit;
}

/// Whether features have not been searched for on a side of a leaf.
bool has_unsearched_side(const Leaf& leaf, const CellTree& tree) {
  return std::ranges::any_of(sides_of(leaf, tree), [&](const Side& side) {
    return !tree.edges().is_searched(side[0], side[1]);
  });
}

/// Whether the one cliff of a leaf is narrow beside it, and may leave it through sides as short as
/// itself, beside smaller leaves that show it without features. The flank of a needle is wide.
bool goes_on_in_sides(const Leaf& leaf, const CellTree& tree) {
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    return glm::distance(tree.vertices().place_between(a), tree.vertices().place_between(b));
  };
  double shortest = kInfinity;
  double width = 0;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    if (const auto feature = tree.edges().feature(a, b)) {
      width = length(feature->beside_first, feature->beside_second);
    } else {
      shortest = std::min(shortest, length(a, b));
    }
  });
  return shortest <= width && width <= kClose * std::max(leaf.size_u(), leaf.size_v());
}

/// The longest edge of a sheet in a leaf, straight from where its line enters to where it leaves.
/// Infinite if no line goes through.
double length_of_cuts(const Leaf& leaf, const CellTree& tree) {
  std::vector<dvec3> ends;  // two at each cut side, in the order of the sides
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature) return;
    for (const std::uint32_t vertex : {feature->beside(a), feature->beside(b)})
      ends.push_back(tree.mesh().position[vertex]);
  });
  if (ends.size() < 4 || !std::ranges::all_of(ends, is_finite)) return kInfinity;
  double longest = 0;
  for (std::size_t k = 1; k < ends.size(); k += 2)
    longest = std::max(longest, glm::distance(ends[k], ends[(k + 1) % ends.size()]));
  return longest;
}

bool covers_leaf(const Leaf& leaf, const CellTree& tree) {
  double area = 0;
  for (const Polygon& polygon : sub_polygons(leaf, tree)) area += 0.5 * doubled_area_of(polygon);
  const double whole = leaf.size_u() * leaf.size_v();
  return std::fabs(area - whole) <= kSame * whole;
}

}  // namespace

bool SplitDirection::is_across_u(std::size_t number, const Oscillation& predicted) const {
  const Leaf& leaf = mesh_.leaves[number];
  const bool is_far = mesh_.error_ratio(number) > 1;
  if (const auto along_u = predicted.splits_predicted_u(leaf, tree_)) return *along_u;
  if (mesh_.triangles.ranges[number].has_flat_sub_polygon && leaf.state.is_cut_by_feature()) {
    if (const auto along_u = flat_sub_polygon_along_u(leaf, tree_)) return *along_u;
  }
  if (leaf.state.is_on_boundary()) return indicator_.splits_boundary_u(leaf);
  if (is_cut_unclearly(number)) return count_features(leaf, tree_).is_parted_along_u(leaf);
  if (is_far && mesh_.sampled_errors[number].on_crease && !is_halved_across_cuts(number))
    return is_cut_along_u(leaf, tree_);
  const CellError error = indicator_.estimate(leaf);
  const ErrorRatios ratios = is_far ? error.distance : error.turn;
  const bool is_significant = std::max(ratios.along_u, ratios.along_v) > kSignificant;
  if (is_significant) return ratios.along_u >= ratios.along_v;
  // The normals at a singular side are not known yet, but turn most there.
  if (!is_far && has_singular_side(leaf.samples, 0) != has_singular_side(leaf.samples, 1)) {
    return has_singular_side(leaf.samples, 1);
  }
  return leaf.size_u() >= leaf.size_v();
}

/// Whether halving across a crease or a jump has made a sliver: the error is in one of its
/// sub-polygons.
bool SplitDirection::is_halved_across_cuts(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  return is_sliver(leaf) && (count_features(leaf, tree_).only_creases ||
                             length_of_cuts(leaf, tree_) <= kUnnoticed * mesh_.allowed[number]);
}

/// Whether one of a leaf's two sides along u (0) or along v (1) is singular at both ends.
bool SplitDirection::has_singular_side(const SampleVertices& samples, std::size_t along) const {
  const auto& corner = samples.corner;
  return is_cusp(corner[along], corner[along + 1], tree_) ||
         is_cusp(corner[along + 2], corner[(along + 3) % 4], tree_);
}

bool SplitDirection::is_cut_unclearly(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (!leaf.state.is_cut_by_feature()) return false;
  const FeatureCount features = count_features(leaf, tree_);
  if (features.only_creases) return mesh_.triangles.ranges[number].has_flat_sub_polygon;
  // A cliff that ends in a leaf leaves it whole. Where a neighbour was just halved, the next search
  // tells whether it does.
  if (features.has_cliffs && !features.is_through())
    return leaf.state.may_be_halved() && !has_unsearched_side(leaf, tree_) &&
           !(features.features == 1 && goes_on_in_sides(leaf, tree_)) && !is_too_small_to_see(leaf);
  if (!features.only_jumps)
    return leaf.state.may_be_halved() && !features.is_through() && !features.is_crease_in_strip();
  const bool may_overlap = !features.is_through() || tree_.inner().has(leaf);
  return features.has_more || (may_overlap && !covers_leaf(leaf, tree_));
}

bool SplitDirection::joins_sheets(std::size_t number) const {
  const std::optional<double> border = border_of_pieces(mesh_.leaves[number], tree_);
  if (!border) return false;
  const double longest = std::max(*border, mesh_.allowed[number]);
  const auto& position = tree_.mesh().position;
  return std::ranges::any_of(mesh_.triangles.of(number), [&](const Triangle& t) {
    return glm::distance(position[t[0]], position[t[1]]) > longest ||
           glm::distance(position[t[1]], position[t[2]]) > longest;
  });
}

}  // namespace saddle
