// Boxes of parameters in which a surface may jump, by bounds.
// Source: J. Tupper, "Reliable two-dimensional graphing methods for mathematical formulae with two
// free variables", 2001.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/proof/proof_budget.h"
#include "mesh/proof/root_cells.h"
#include "surface/parameter_box.h"
#include "surface/surface.h"

namespace saddle {

/// A box that is searched for a jump.
struct JumpBox {
  ParameterBox box;
  double least;  ///< smaller jumps do not count
};

/// For each cell of the root grid, 1 if bounds over it do not exclude a jump; 0 for the others, and
/// for all that the budget leaves untested.
std::vector<std::uint8_t> cells_that_may_jump(const Surface& surface, const RootLines& root,
                                              ProofBudget& budget);

/// The numbers of the boxes that have a part, after kMaxBrokenDepth halvings, over which the
/// surface is proved to be defined, and its bounds do not exclude a jump; and of those with too
/// many parts to look at. `threads`: 0 for all. Where the budget ends, so does the list; it does
/// not depend on the number of threads.
std::vector<std::size_t> find_may_jump(const Surface& surface, std::span<const JumpBox> boxes,
                                       ProofBudget& budget, unsigned threads);

}  // namespace saddle
