// Detects aliasing: where the surface oscillates faster than leaves of visible size can follow.
#pragma once

#include <optional>
#include <unordered_map>

#include "mesh/error/error_indicator.h"
#include "mesh/grid/grid.h"
#include "mesh/sizing/aliasing_forecast.h"

namespace saddle {

class CellTree;

/// Counts unresolvable leaves: narrow ones whose error is still large. Where they fill an area, the
/// surface oscillates, and leaves are not halved further; along a line, as at a jump, they are.
class Oscillation {
 public:
  /// `tolerance`: as a share of the surface's diagonal.
  Oscillation(const Grid& grid, double tolerance);

  /// The size of the widest narrow leaf, in parameters.
  dvec2 narrow_size() const { return narrow_ * grid_.range; }
  /// Predicts which leaves of that size will be unresolvable, by linearisation errors: second
  /// derivatives tell the lengths of waves before a leaf is halved.
  void predict(LinearizationErrors linearization_errors);

  void clear() { blocks_.clear(); }
  /// Counts a leaf with these error ratios, if it is unresolvable.
  void add(const Leaf& leaf, const ErrorRatios& distance, const CellTree& tree);
  /// Counts an unresolvable leaf.
  void add(const Leaf& leaf, const CellTree& tree);
  /// Whether a leaf is narrow and part of an oscillation, by the leaves counted so far. Its sides
  /// are not searched for features either: there would be too many.
  bool contains(const Leaf& leaf, const CellTree& tree) const;
  /// Whether to halve a leaf across u, if it is not narrow yet and predicted to be unresolvable
  /// once it is; else empty. The samples of a leaf with many waves do not tell the direction.
  std::optional<bool> splits_predicted_u(const Leaf& leaf, const CellTree& tree) const;

 private:
  /// The unresolvable leaves in a block of the domain.
  struct Block {
    double area = 0;    ///< in blocks
    double length = 0;  ///< sum of their longer sides, in sides of a block
  };
  glm::bvec2 predicted(const Leaf& leaf, const CellTree& tree) const;
  dvec2 size_of(const Leaf& leaf, const CellTree& tree) const;  ///< in widths of narrow leaves
  /// Whether an oscillation fills the block with these numbers.
  bool fills(std::uint32_t u, std::uint32_t v) const;

  const Grid& grid_;
  double narrow_;                  ///< in ranges
  std::uint32_t size_u_, size_v_;  ///< of a block, in units
  std::unordered_map<std::uint64_t, Block> blocks_;
  AliasingForecast forecast_;
};

}  // namespace saddle
