// The error indicator of many leaves at a time, by vector loops on several threads. Most leaves are
// smooth and pass.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/error/error_indicator.h"

namespace saddle {

/// The error of a leaf, as far as it is known.
struct FastCellError {
  bool is_known = false;    ///< false: the loops cannot tell
  bool passes = false;      ///< the loops' distance and normals, by the leaf's safety factors
  float distance = 0;       ///< the largest error ratio of distances, if it passes
  std::uint32_t error = 0;  ///< number of its CellError, if it is known and does not pass
};
struct FastCellErrors {
  std::vector<FastCellError> leaves;
  std::vector<CellError> errors;  ///< of leaves that are known and that the loops do not pass

  /// The error of a leaf that the loops do not pass; nullptr for others and where none is known.
  const CellError* error(const FastCellError& fast) const {
    return fast.is_known && !fast.passes ? &errors[fast.error] : nullptr;
  }
};

/// Estimates leaves whose samples are known. The loops do not know leaves that fold, bend too much
/// for arcs or are not smooth, have edge features or are beside a pole. With a clip box they know
/// only leaves that pass.
FastCellErrors estimate_many(std::span<const Leaf> leaves, const CellLimits& limits,
                             const ErrorIndicator& indicator, const CellTree& tree);

/// Estimates, one by one, the leaves that the loops left unknown, except those that are clipped or
/// have undefined samples.
void estimate_others(std::span<const Leaf> leaves, const CellLimits& limits,
                     const ErrorIndicator& indicator, const CellTree& tree, FastCellErrors& errors);

}  // namespace saddle
