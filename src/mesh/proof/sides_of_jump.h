// The two sides of a jump in a box of parameters.
#pragma once

#include <array>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "mesh/proof/root_cells.h"
#include "surface/parameter_box.h"

namespace saddle {

/// The sides, from the double on at which bounds prove the surface to be continuous on both:
/// `is_broken(box)` tells whether they do not. Beside 0 doubles are closer than what tells jumps
/// from slopes.
template <class IsBroken>
std::optional<std::array<ParameterBox, 2>> sides_of_jump(const JumpLine& line,
                                                         const ParameterBox& box,
                                                         IsBroken is_broken) {
  const auto& [axis, below, above] = line;
  const ParameterBox whole = {glm::min(box.low, box.high), glm::max(box.low, box.high)};
  for (const double cut :
       {above, std::nextafter(below, kInfinity), 0.0, std::nextafter(0.0, kInfinity)}) {
    if (!(below < cut && cut <= above)) continue;
    std::array<ParameterBox, 2> sides = {whole, whole};
    sides[0].high[axis] = std::nextafter(cut, -kInfinity);
    sides[1].low[axis] = cut;
    std::array<ParameterBox, 2> beside = sides;  // the jump
    beside[0].low[axis] = below;
    beside[1].high[axis] = above;
    if (!is_broken(beside[0]) && !is_broken(beside[1])) return sides;
  }
  return std::nullopt;
}

}  // namespace saddle
