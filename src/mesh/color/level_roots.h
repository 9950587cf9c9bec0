// Places between two others where a number is a level.
#pragma once

#include <span>
#include <vector>

#include "base/vec.h"
#include "surface/surface.h"

namespace saddle {

/// A straight way in the parameters, at whose ends the number minus the level has opposite signs;
/// 0 counts as positive.
struct LevelBracket {
  dvec2 from, to;
  double at_from = 0;  ///< the number minus the level there
  double at_to = 0;
  double level = 0;
  double part = 0;       ///< the result: where on the way, 0 to 1
  bool is_jump = false;  ///< the number jumps over the level there, or is not defined
};

/// Finds a root in each bracket to the last digits of the parameters, all together. Source: the
/// Illinois method, M. Dowell, P. Jarratt, "A modified regula falsi method for computing the root
/// of an equation", 1971, with a bisection every third step.
void find_level_roots(const Surface& surface, std::span<LevelBracket> brackets, unsigned threads);

}  // namespace saddle
