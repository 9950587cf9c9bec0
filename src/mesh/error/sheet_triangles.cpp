#include "mesh/error/sheet_triangles.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include "mesh/model/sample_places.h"
#include "mesh/model/sides.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

/// The places are the middles of diagonals, and of sides that end at the feature. Two kinds of
/// sides between two places on features have several: the chord of a jump that ends at a crease
/// leads past the corner, and the diagonal of a wall whose foot and head change places leads past
/// its neck.
void SheetTriangles::add(const ValidatedMesh& mesh, std::size_t number,
                         std::span<const Triangle> triangles) {
  const Leaf& leaf = mesh.leaves[number];
  if (!leaf.state.is_cut_by_feature() || triangles.empty() || !mesh.is_near(number)) return;
  const FeatureCount features = count_features(leaf, tree_);
  if (!features.only_jumps || features.only_creases || features.leads_to_pole) return;
  leaves_.push_back({triangles.data(), number});
  for_triangle_sides(triangles, [&](const Triangle& t, std::size_t k, bool is_diagonal) {
    const auto add = [&](double share) {
      dvec3 weights(0);
      weights[static_cast<int>(k)] = 1 - share;
      weights[static_cast<int>((k + 1) % 3)] = share;
      places_.push_back({&t, weights});
    };
    const bool begins_at_feature = tree_.vertices().is_on_feature(t[k]);
    const bool ends_at_feature = tree_.vertices().is_on_feature(t[(k + 1) % 3]);
    const bool may_pass = is_diagonal ? features.has_cliffs : features.creases > 0;
    if (begins_at_feature && ends_at_feature && may_pass) {
      for (const double share : kAlongLine) add(share);
    } else if (is_diagonal || begins_at_feature != ends_at_feature) {
      add(0.5);
    }
  });
}

void SheetTriangles::measure(ValidatedMesh& mesh) const {
  if (places_.empty()) return;
  double least = std::numeric_limits<double>::infinity();
  for (const TrianglesOfLeaf& leaf : leaves_) least = std::min(least, mesh.allowed[leaf.leaf]);
  std::vector<TrianglesOfLeaf> sorted = leaves_;
  std::ranges::sort(sorted, {}, &TrianglesOfLeaf::first);
  const WholeMeshError whole(surface_, grid_, {}, {}, threads_, tree_.edges().has_cliffs());
  for (const auto& [triangle, distance] : whole.farther_than(least, least, places_)) {
    const auto next = std::ranges::upper_bound(sorted, triangle, {}, &TrianglesOfLeaf::first);
    const std::size_t leaf = std::prev(next)->leaf;
    if (distance > mesh.allowed[leaf]) mesh.add(leaf, distance);
  }
}

}  // namespace saddle
