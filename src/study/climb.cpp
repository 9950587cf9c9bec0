#include "study/climb.h"

#include <algorithm>
#include <array>

namespace saddle {

namespace {

/// Parts of the ranges that the first and the last steps take. A smooth peak is flat: at a distance
/// of 2^-30 its value has changed by 2^-60 of what it does over the range.
constexpr double kFirstStep = 1.0 / 64;
constexpr double kLastStep = 1.0 / (1 << 30);
/// Steps of a size before it is halved all the same: a slope that goes on is not worth more.
constexpr int kMostSteps = 64;

constexpr std::array<dvec2, 8> kWays = {dvec2(1, 0),  dvec2(1, 1),   dvec2(0, 1),  dvec2(-1, 1),
                                        dvec2(-1, 0), dvec2(-1, -1), dvec2(0, -1), dvec2(1, -1)};

dvec2 inside(const Domain& d, const dvec2& uv) {
  return {std::clamp(uv.x, std::min(d.u0, d.u1), std::max(d.u0, d.u1)),
          std::clamp(uv.y, std::min(d.v0, d.v1), std::max(d.v0, d.v1))};
}

/// Goes to the best of the places a step away; false if none is better.
bool step_up(const Domain& domain, const dvec2& step, const ValuesAt& values, Peak& peak) {
  std::array<dvec2, kWays.size()> places;
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    places[k] = inside(domain, peak.uv + kWays[k] * step);
  }
  const std::vector<double> found = values(places);
  const Peak before = peak;
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    if (found[k] > peak.value) peak = {places[k], found[k]};
  }
  return peak.value > before.value;
}

}  // namespace

Peak climb(const Domain& domain, Peak start, const ValuesAt& values) {
  const dvec2 size(domain.u1 - domain.u0, domain.v1 - domain.v0);
  for (double part = kFirstStep; part >= kLastStep; part /= 2) {
    int steps = 0;
    while (steps < kMostSteps && step_up(domain, part * size, values, start)) ++steps;
  }
  return start;
}

}  // namespace saddle
