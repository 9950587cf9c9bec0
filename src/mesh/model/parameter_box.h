// Boxes and lines of parameters.
#pragma once

#include <vector>

#include "base/vec.h"

namespace saddle {

/// A rectangle of parameters; `low` may be the larger where a range runs backwards.
struct ParameterBox {
  dvec2 low, high;
  dvec2 middle() const { return 0.5 * low + 0.5 * high; }
  dvec2 size() const { return glm::abs(high - low); }
};

/// `cells` + 1 evenly spaced parameters, both ends exact.
std::vector<double> even_lines(double first, double last, std::size_t cells);

}  // namespace saddle
