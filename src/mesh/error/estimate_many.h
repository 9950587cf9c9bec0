// The error indicator of many leaves at a time, by vector loops. Most leaves are smooth and pass.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/error/error_indicator.h"

namespace saddle {

/// The error of a leaf, as far as the loops know it.
struct FastCellError {
  bool is_known = false;    ///< false: only ErrorIndicator::estimate() applies
  bool passes = false;      ///< distance and normals, by the leaf's safety factors
  float distance = 0;       ///< the largest error ratio of distances, if it passes
  std::uint32_t error = 0;  ///< number of its CellError, if it does not pass
};
struct FastCellErrors {
  std::vector<FastCellError> leaves;
  std::vector<CellError> errors;  ///< of the few that fail

  /// The error of a leaf that is known not to pass; nullptr for others.
  const CellError* error(const FastCellError& fast) const {
    return fast.is_known && !fast.passes ? &errors[fast.error] : nullptr;
  }
};

/// Estimates leaves whose samples are known. The loops do not know leaves that fold, bend too much
/// for arcs or are not smooth, have edge features or are beside a pole. With a clip box they know
/// only leaves that pass.
FastCellErrors estimate_many(std::span<const Leaf> leaves, const CellLimits& limits,
                             const ErrorIndicator& indicator, const CellTree& tree);

}  // namespace saddle
