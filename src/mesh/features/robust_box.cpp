#include "mesh/features/robust_box.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/random.h"
#include "mesh/model/tolerances.h"

namespace saddle {

double quantile(std::span<double> numbers, double share) {
  if (numbers.empty()) return 0;
  const auto place = std::min(static_cast<std::size_t>(share * static_cast<double>(numbers.size())),
                              numbers.size() - 1);
  std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(place));
  return numbers[place];
}

namespace {

/// The share of the points that is left out at either end: seldom less than goes to infinity.
constexpr double kTail = 0.05;
/// The share that may be left out for a box's shape: a box holds the middle half of the points.
constexpr double kLongestTail = 0.25;
/// Windows that are tried: they begin or end at every 256th part of the points, and so move by less
/// than a tail.
constexpr std::size_t kTries = 256;
/// Lines each way, through the middles of even stretches of a domain, and points of a rough box. A
/// tail of one line is six points.
constexpr std::size_t kLines = 128;

/// An interval on a line.
struct Stretch {
  double low = 0, high = 0;
  double length() const { return high - low; }
};

using Numbers = std::span<const double>;

Stretch without_tails(Numbers sorted, double tail) {
  const auto place = [&](double share) {
    return std::min(static_cast<std::size_t>(share * static_cast<double>(sorted.size())),
                    sorted.size() - 1);
  };
  return {sorted[place(tail)], sorted[place(1 - tail)]};
}

/// The clusters of numbers between gaps of more than `gap`. Numbers between gaps that are no more
/// than a tail belong to the cluster before them, or to the first one.
std::vector<Numbers> parts_of(Numbers sorted, double gap) {
  const double least = kTail * static_cast<double>(sorted.size());
  std::vector<std::size_t> begins;
  std::size_t begin = 0;
  for (std::size_t end = 1; end <= sorted.size(); ++end) {
    if (end < sorted.size() && sorted[end] - sorted[end - 1] <= gap) continue;
    if (static_cast<double>(end - begin) > least) begins.push_back(begins.empty() ? 0 : begin);
    begin = end;
  }
  if (begins.empty()) return {sorted};
  begins.push_back(sorted.size());
  std::vector<Numbers> parts;
  for (std::size_t k = 0; k + 1 < begins.size(); ++k) {
    parts.push_back(sorted.subspan(begins[k], begins[k + 1] - begins[k]));
  }
  return parts;
}

std::size_t count_within(Numbers sorted, const Stretch& window) {
  const auto first = std::ranges::lower_bound(sorted, window.low);
  const auto last = std::ranges::upper_bound(sorted, window.high);
  return last > first ? static_cast<std::size_t>(last - first) : 0;
}

/// The window of this length whose least share of a cluster is largest: it shows both sides of a
/// pole, not the larger one alone. A tie goes to the window that shows the most in all, then to
/// the middle one.
Stretch fairest_window(Numbers sorted, double length) {
  const std::vector<Numbers> parts = parts_of(sorted, kFarApart * length);
  const auto worth = [&](const Stretch& window) {
    double least = 1;
    for (const Numbers& part : parts) {
      const auto shown = static_cast<double>(count_within(part, window));
      least = std::min(least, shown / static_cast<double>(part.size()));
    }
    return std::pair(least, count_within(sorted, window));
  };
  std::vector<double> best;  // where windows begin
  std::pair<double, std::size_t> most = {0, 0};
  const std::size_t step = std::max<std::size_t>(sorted.size() / kTries, 1);
  for (std::size_t k = 0; k < sorted.size(); k += step) {
    for (const double low : {sorted[k], sorted[sorted.size() - 1 - k] - length}) {
      const auto found = worth({low, low + length});
      if (found > most) best.clear();
      most = std::max(most, found);
      if (found == most) best.push_back(low);
    }
  }
  // Halfway between the first and the last, if that is as good within a step of the tries: then
  // symmetric points have a symmetric box.
  const auto [first, last] = std::ranges::minmax(best);
  const double middle = 0.5 * (first + last);
  const bool is_good = worth({middle, middle + length}).first >= most.first - 1.0 / kTries;
  const double low = is_good ? middle : quantile(best, 0.5);
  return {low, low + length};
}

}  // namespace

Bounds robust_box(std::span<const dvec3> points, const dvec3& longest) {
  Bounds box;
  if (points.empty()) return box;
  std::vector<double> numbers(points.size());
  for (int k = 0; k < 3; ++k) {
    std::ranges::transform(points, numbers.begin(), [k](const dvec3& p) { return p[k]; });
    std::ranges::sort(numbers);
    Stretch kept = without_tails(numbers, kTail);
    const double most = std::max(longest[k], without_tails(numbers, kLongestTail).length());
    if (kept.length() > most) kept = fairest_window(numbers, most);
    box.low[k] = kept.low;
    box.high[k] = kept.high;
  }
  return box;
}

Bounds rough_box(std::span<const dvec3> points) {
  std::vector<dvec3> some;
  const std::size_t count = std::min(points.size(), kLines);
  some.reserve(count);
  for (std::size_t k = 0; k < count; ++k) some.push_back(points[k * points.size() / count]);
  return robust_box(some);
}

std::vector<dvec3> balanced_positions(const Surface& surface, unsigned threads) {
  std::vector<double> parts(kLines);
  for (std::size_t i = 0; i < kLines / 2; ++i) {
    const double shift = kLineJitter * (2 * random_unit(i) - 1);
    parts[i] = (static_cast<double>(i) + 0.5 + shift) / kLines;
    parts[kLines - 1 - i] = 1 - parts[i];
  }
  const auto lines = [&](double first, double last) {
    std::vector<double> at(kLines);
    std::ranges::transform(parts, at.begin(),
                           [&](double part) { return first * (1 - part) + last * part; });
    return at;
  };
  const Domain& d = surface.domain;
  std::vector<dvec3> positions;
  for (const SurfacePoint& point :
       evaluate_on_grid(surface, lines(d.u0, d.u1), lines(d.v0, d.v1), threads)) {
    if (is_finite(point.position)) positions.push_back(point.position);
  }
  return positions;
}

}  // namespace saddle
