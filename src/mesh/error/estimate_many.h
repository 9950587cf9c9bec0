// Many leaves judged at a time: most of them are smooth and near enough.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/error/error_indicator.h"

namespace saddle {

/// What is seen of a leaf at a glance.
struct FastCellError {
  bool is_known = false;    ///< else ErrorIndicator::score() is to be asked, which may say anything
  bool passes = false;      ///< all tests, by the leaf's strictness
  float distance = 0;       ///< how far off it is at most, in tolerances, if it passes
  std::uint32_t error = 0;  ///< the number of what ErrorIndicator::score() says, if it does not
};
struct FastCellErrors {
  std::vector<FastCellError> leaves;
  std::vector<CellError> errors;  ///< of the few that fail

  /// What is known of a leaf that does not pass; nullptr of others.
  const CellError* error(const FastCellError& fast) const {
    return fast.is_known && !fast.passes ? &errors[fast.error] : nullptr;
  }
};

/// Judges leaves whose samples are known. Not known is what folds, bends too much for arcs or is
/// not smooth, what something cuts or a pole is beside; with a clip box, all that does not pass.
FastCellErrors estimate_many(std::span<const Leaf> leaves, const RefineOptions& options,
                             const ErrorIndicator& indicator, const CellTree& tree);

}  // namespace saddle
