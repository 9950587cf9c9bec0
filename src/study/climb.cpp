#include "study/climb.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace saddle {

namespace {

/// Parts of the ranges that the first and the last steps take. A smooth peak is flat: at a distance
/// of 2^-30 its value has changed by 2^-60 of what it does over the range. Around a
/// narrow peak steps go on until values a step away differ by at most kFlat of the peak's.
constexpr double kFirstStep = 1.0 / 64;
constexpr double kLastStep = 0x1p-30;
constexpr double kLeastStep = 0x1p-50;
constexpr double kFlat = 1e-9;
/// Steps of a size before it is halved all the same: a slope that goes on is not worth more.
constexpr int kMostSteps = 64;

constexpr std::array<dvec2, 8> kWays = {dvec2(1, 0),  dvec2(1, 1),   dvec2(0, 1),  dvec2(-1, 1),
                                        dvec2(-1, 0), dvec2(-1, -1), dvec2(0, -1), dvec2(1, -1)};

dvec2 inside(const Domain& d, const dvec2& uv) {
  return {std::clamp(uv.x, std::min(d.u0, d.u1), std::max(d.u0, d.u1)),
          std::clamp(uv.y, std::min(d.v0, d.v1), std::max(d.v0, d.v1))};
}

/// The result of a look at the places a step away.
enum class Step { Up, Flat, Down };

/// Goes to the best of the places a step away.
Step step_up(const Domain& domain, const dvec2& step, const ValuesAt& values, Peak& peak) {
  std::array<dvec2, kWays.size()> places;
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    places[k] = inside(domain, peak.uv + kWays[k] * step);
  }
  const std::vector<double> found = values(places);
  const Peak before = peak;
  bool is_flat = true;
  for (std::size_t k = 0; k < kWays.size(); ++k) {
    is_flat = is_flat && std::fabs(found[k] - before.value) <= kFlat * std::fabs(before.value);
    if (found[k] > peak.value) peak = {places[k], found[k]};
  }
  if (peak.value > before.value) return Step::Up;
  return is_flat ? Step::Flat : Step::Down;
}

}  // namespace

Peak climb(const Domain& domain, Peak start, const ValuesAt& values) {
  const dvec2 size(domain.u1 - domain.u0, domain.v1 - domain.v0);
  for (double part = kFirstStep; part >= kLeastStep; part /= 2) {
    Step last = Step::Up;
    for (int steps = 0; steps < kMostSteps && last == Step::Up; ++steps) {
      last = step_up(domain, part * size, values, start);
    }
    if (part <= kLastStep && last == Step::Flat) break;
  }
  return start;
}

}  // namespace saddle
