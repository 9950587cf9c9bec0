#include "surface/surface_enclosure.h"

#include <algorithm>

namespace saddle {

bool are_continuous(std::span<const Interval> bounds) {
  return std::ranges::all_of(
      bounds, [](const Interval& a) { return a.defined == Defined::Yes && a.continuous; });
}

Defined least_defined(std::span<const Interval> bounds) {
  Defined least = Defined::Yes;
  for (const Interval& a : bounds) least = std::min(least, a.defined);
  return least;
}

Bounds hull_of(std::span<const Interval> bounds) {
  return {{bounds[0].low, bounds[1].low, bounds[2].low},
          {bounds[0].high, bounds[1].high, bounds[2].high}};
}

}  // namespace saddle
