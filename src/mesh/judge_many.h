// Many leaves judged at a time: most of them are smooth and near enough.
#pragma once

#include <span>
#include <vector>

#include "mesh/judge.h"

namespace saddle {

/// What is not said of a leaf by judge_many().
inline constexpr float kUnknown = -1;

/// How far off leaves are that surely pass all tests of Judge::score(), in tolerances; kUnknown of
/// the others, which may pass, too. Leaves that something cuts, or that a pole is beside, are left
/// to others as well.
std::vector<float> judge_many(std::span<const Leaf> leaves, const RefineOptions& options,
                              const Judge& judge, const Lattice& lattice);

}  // namespace saddle
