// Limits of subdivision: how many halvings of a root cell lead to a leaf, by what is in the leaf,
// and when halving a leaf no longer helps.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>

#include "mesh/model/tolerances.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct FeatureCount;

/// So many halvings in a row that do not help are no chance: one may go in the wrong direction, or
/// the parent was too large to sample its own error. The sides of a leaf are searched after each 2.
inline constexpr std::uint8_t kInVain = 2;
/// An error above tolerance no longer halves a leaf once more than 12 consecutive halvings did not
/// help. Normals turn at any size around a point where sheets meet; 12 halvings make it invisible.
inline constexpr std::uint8_t kMaxStagnation = 12;

/// Halvings of a root cell that the boundary crosses, at first: 4.
inline constexpr int kBoundaryHalvings = 4;
/// Halvings of a root cell whose edge features are more than one line, at most: 14.
inline constexpr int kMostCutHalvings = 14;
/// Halvings of a root cell in all: 16 each way.
inline constexpr int kMostHalvings = 2 * std::countr_zero(kCellUnit);

/// Halvings of the root cell of a leaf.
inline int halvings_of_root(const Leaf& leaf) {
  return std::countr_zero(kCellUnit / leaf.size_u()) + std::countr_zero(kCellUnit / leaf.size_v());
}
/// The same without those that led to a landmark.
inline int halvings(const Leaf& leaf) {
  return halvings_of_root(leaf) - leaf.sought;
}

/// Halvings of a leaf with a boundary that reach the boundary's wanted precision: 4, and one more
/// for each time that validation doubled its safety.
int boundary_halvings(const Leaf& leaf, const CellTree& tree);
/// The largest number of them.
int most_boundary_halvings(const Leaf& leaf, const CellTree& tree);
/// Halvings of a leaf with these edge features: none for a single line.
int wanted_halvings(const FeatureCount& features);

/// Consecutive halvings that did not help, from those of the parent: one helps if the error ratio
/// shrinks.
inline std::uint8_t count_stagnation(std::uint8_t before, double ratio, double parent_ratio) {
  return ratio <= std::max(kShrinks * parent_ratio, 1.0) ? std::uint8_t{0}
                                                         : static_cast<std::uint8_t>(before + 1);
}

/// Whether the sides of a leaf are searched for features: it has one already, or stagnates.
bool is_search_due(const Leaf& leaf);

}  // namespace saddle
