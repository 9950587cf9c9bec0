// Counterexamples: points of the surface that show that a cell of the mesh misses it.
#pragma once

#include <cstddef>
#include <optional>

#include "base/vec.h"

namespace saddle {

/// A known point of the surface, or of a hole, in a cell that may be too large.
struct Counterexample {
  dvec2 uv;
  dvec3 position;    ///< not finite in a hole
  dvec2 size;        ///< of the box of parameters that it stands for
  dvec2 bend;        ///< second derivatives along u and along v there, in any unit
  std::size_t cell;  ///< number of the cell
  /// |r_u| and |r_v| at a landmark (proof/landmarks.h), which leaves with features reach, too.
  std::optional<dvec2> speed = {};
};

}  // namespace saddle
