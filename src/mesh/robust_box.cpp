#include "mesh/robust_box.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace saddle {
namespace {

/// The share of the points that is left out at either end: what a surface takes to infinity is
/// seldom more, and what is left shows how large the rest is.
constexpr double kTail = 0.05;
/// What may be left out for the sake of a box's shape, and the steps to it: the middle half of the
/// points is seen whatever the rest does.
constexpr double kLongestTail = 0.25;
constexpr int kSteps = 20;

}  // namespace

double quantile(std::span<double> numbers, double share) {
  if (numbers.empty()) return 0;
  const auto place = std::min(static_cast<std::size_t>(share * static_cast<double>(numbers.size())),
                              numbers.size() - 1);
  std::ranges::nth_element(numbers, numbers.begin() + static_cast<std::ptrdiff_t>(place));
  return numbers[place];
}

Bounds robust_box(std::span<const dvec3> points, const dvec3& longest) {
  Bounds box;
  for (int k = 0; k < 3; ++k) {
    std::vector<double> numbers;
    numbers.reserve(points.size());
    for (const dvec3& p : points) numbers.push_back(p[k]);
    for (int step = 0; step <= kSteps; ++step) {
      const double tail = kTail + (kLongestTail - kTail) * step / kSteps;
      box.low[k] = quantile(numbers, tail);
      box.high[k] = quantile(numbers, 1 - tail);
      if (box.high[k] - box.low[k] <= longest[k]) break;
    }
  }
  return box;
}

}  // namespace saddle
