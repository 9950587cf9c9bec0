// Many leaves judged at a time: most of them are smooth and near enough.
#pragma once

#include <span>
#include <vector>

#include "mesh/judge.h"

namespace saddle {

/// What is seen of a leaf at a glance.
struct Glance {
  bool is_known = false;  ///< else Judge::score() is to be asked, which may say anything
  bool passes = false;    ///< all tests, by the leaf's strictness
  Verdict verdict = {};   ///< as Judge::score() says; the turn of a leaf that passes is left out
};

/// Judges leaves whose samples are known. Not known is what folds, bends too much for arcs or is
/// not smooth, what something cuts or a pole is beside; with a clip box, all that does not pass.
std::vector<Glance> judge_many(std::span<const Leaf> leaves, const RefineOptions& options,
                               const Judge& judge, const Lattice& lattice);

}  // namespace saddle
