#include "surface/surface_enclosure.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/numbers.h"

namespace saddle {

bool are_continuous(std::span<const Interval> bounds) {
  return std::ranges::all_of(bounds, is_continuous);
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

std::size_t KnownHulls::HashOfBox::operator()(const std::array<double, 4>& box) const {
  constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15ULL;  // 2^64 / golden ratio
  std::uint64_t hash = 0;
  for (const double end : box) hash = (hash ^ std::bit_cast<std::uint64_t>(end)) * kSpread;
  return hash >> 32U;
}

Bounds KnownHulls::over(const ParameterBox& box) {
  if (!enclosure_) {
    enclosure_.emplace(surface_, Bounded::Position);
    keeps_ = enclosure_->steps() >= kStepsToKeep;
  }
  if (!keeps_) return hull_of(enclosure_->enclose(box));
  const std::array<double, 4> ends = {box.low.x, box.low.y, box.high.x, box.high.y};
  if (known_.size() < kMostKnown) {
    const auto [place, is_new] = known_.try_emplace(ends);
    if (is_new) place->second = hull_of(enclosure_->enclose(box));
    return place->second;
  }
  const auto known = known_.find(ends);
  return known != known_.end() ? known->second : hull_of(enclosure_->enclose(box));
}

double room_beyond(const Bounds& points, const Bounds& bounds) {
  dvec3 excess(0);
  for (int k = 0; k < 3; ++k)
    excess[k] = std::max({points.low[k] - bounds.low[k], bounds.high[k] - points.high[k], 0.0});
  const double room = glm::length(excess);
  if (std::isnan(room)) return kInfinity;
  return room;
}

}  // namespace saddle
