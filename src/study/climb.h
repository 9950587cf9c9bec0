// Smallest and largest values on the domain, from the best of some samples on.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "surface/surface.h"

namespace saddle {

/// A value and the parameters that have it.
struct Peak {
  dvec2 uv;
  double value;
};

/// Numbers at places; NaN where there is none.
using ValuesAt = std::function<std::vector<double>(std::span<const dvec2>)>;

/// The largest value that a search from `start` on finds within the domain, exact to the rounding
/// of the values where they are smooth or end at an edge. Compass search with diagonals. Source:
/// T. G. Kolda, R. M. Lewis, V. Torczon, "Optimization by direct search", SIAM Review, 2003.
Peak climb(const Domain& domain, Peak start, const ValuesAt& values);

}  // namespace saddle
