// Where halving comes to no end.
#pragma once

#include <optional>
#include <unordered_map>

#include "mesh/error/error_indicator.h"
#include "mesh/grid/grid.h"
#include "mesh/sizing/aliasing_forecast.h"

namespace saddle {

class CellTree;

/// Where the surface oscillates faster than its tolerance shows: where leaves that are narrow and
/// still far off fill an area, as no jump does, which is a line. They are halved no further.
class Oscillation {
 public:
  /// `tolerance`: as a share of the surface's diagonal.
  Oscillation(const Grid& grid, double tolerance);

  /// The size of the widest narrow leaf, in parameters.
  dvec2 narrow_size() const { return narrow_ * grid_.range; }
  /// Takes for hopeless what leaves of that size will be, by how far they depart from their linear
  /// approximation: second derivatives tell how short waves are before any leaf is halved.
  void predict(LinearizationErrors linearization_errors);

  void clear() { blocks_.clear(); }
  /// Counts a leaf that is off by so many tolerances, if it is hopeless.
  void add(const Leaf& leaf, const ErrorRatios& distance, const CellTree& tree);
  /// Counts a hopeless leaf.
  void add(const Leaf& leaf, const CellTree& tree);
  /// Whether a leaf, narrow as well, is part of an oscillation, as far as leaves have been counted.
  /// There is no use in looking for what cuts it, either: jumps would be too many.
  bool contains(const Leaf& leaf, const CellTree& tree) const;
  /// Whether to halve a leaf across u, if it is foreseen to be hopeless once it is narrow, and is
  /// not yet: its samples, of many waves, do not tell.
  std::optional<bool> splits_predicted_u(const Leaf& leaf, const CellTree& tree) const;
  /// Whether a leaf is so narrow in one direction that it had better be halved in the other.
  bool is_sliver(const Leaf& leaf, const CellTree& tree) const;

 private:
  /// What there is in a block of hopeless leaves.
  struct Block {
    double area = 0;    ///< in blocks
    double length = 0;  ///< of their longer sides, in blocks' sides
  };
  glm::bvec2 predicted(const Leaf& leaf, const CellTree& tree) const;
  dvec2 size_of(const Leaf& leaf, const CellTree& tree) const;  ///< in widths of narrow ones
  std::uint64_t block_of(const Leaf& leaf) const;

  const Grid& grid_;
  double narrow_;                  ///< in ranges
  std::uint32_t size_u_, size_v_;  ///< of a block, in units
  std::unordered_map<std::uint64_t, Block> blocks_;
  AliasingForecast forecast_;
};

}  // namespace saddle
