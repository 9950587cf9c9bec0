// Many leaves judged at a time: most of them are smooth and near enough.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/error/judge.h"

namespace saddle {

/// What is seen of a leaf at a glance.
struct Glance {
  bool is_known = false;      ///< else Judge::score() is to be asked, which may say anything
  bool passes = false;        ///< all tests, by the leaf's strictness
  float distance = 0;         ///< how far off it is at most, in tolerances, if it passes
  std::uint32_t verdict = 0;  ///< the number of what Judge::score() says, if it does not
};
struct Glances {
  std::vector<Glance> leaves;
  std::vector<Verdict> verdicts;  ///< of the few that fail

  /// What is known of a leaf that does not pass; nullptr of others.
  const Verdict* verdict(const Glance& glance) const {
    return glance.is_known && !glance.passes ? &verdicts[glance.verdict] : nullptr;
  }
};

/// Judges leaves whose samples are known. Not known is what folds, bends too much for arcs or is
/// not smooth, what something cuts or a pole is beside; with a clip box, all that does not pass.
Glances judge_many(std::span<const Leaf> leaves, const RefineOptions& options, const Judge& judge,
                   const Lattice& lattice);

}  // namespace saddle
