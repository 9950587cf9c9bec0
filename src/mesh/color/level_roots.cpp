#include "mesh/color/level_roots.h"

#include <cmath>
#include <cstddef>

namespace saddle {
namespace {

/// Bisections alone halve a bracket to the last digit in 53 steps; every third step is one.
constexpr int kMostSteps = 3 * 53;
/// A bracket this short, as a share of the way, is the root.
constexpr double kShortest = 0x1p-48;
/// Within a bracket of 2^-48 of the way even a root of third order falls to 2^-16 of its values at
/// the ends; a jump stays as it is.
constexpr double kJumps = 1e-3;
/// The number is the level but for rounding, as a share of the values at the ends.
constexpr double kOnLevel = 0x1p-50;

/// The state of one bracket: the root is between the parts `low` and `high`.
struct RootSearch {
  std::size_t index = 0;
  double low = 0, high = 1;
  double at_low = 0, at_high = 0;          // the true values
  double weight_low = 1, weight_high = 1;  // of an end that stays, halved each time
  double next = 0.5;

  void choose(int step) {
    next = low + (high - low) / 2;
    if (step % 3 == 2) return;
    const double a = weight_low * at_low;
    const double b = weight_high * at_high;
    const double secant = (low * b - high * a) / (b - a);
    if (secant > low && secant < high) next = secant;
  }

  void take(double value) {
    if ((value >= 0) == (at_high >= 0)) {
      high = next;
      at_high = value;
      weight_high = 1;
      weight_low /= 2;
    } else {
      low = next;
      at_low = value;
      weight_low = 1;
      weight_high /= 2;
    }
  }
};

/// Whether the search is at its end, with the result.
bool is_found(const RootSearch& search, LevelBracket& bracket) {
  const double size = std::abs(bracket.at_from) + std::abs(bracket.at_to);
  const bool nearer_low = std::abs(search.at_low) < std::abs(search.at_high);
  bracket.part = nearer_low ? search.low : search.high;
  if (std::min(std::abs(search.at_low), std::abs(search.at_high)) <= kOnLevel * size) return true;
  if (search.high - search.low > kShortest) return false;
  bracket.is_jump = !(std::abs(search.at_high - search.at_low) <= kJumps * size);
  return true;
}

}  // namespace

void find_level_roots(const Surface& surface, std::span<LevelBracket> brackets, unsigned threads) {
  std::vector<RootSearch> open;
  for (std::size_t i = 0; i < brackets.size(); ++i) {
    RootSearch search;
    search.index = i;
    search.at_low = brackets[i].at_from;
    search.at_high = brackets[i].at_to;
    if (!is_found(search, brackets[i])) open.push_back(search);
  }
  std::vector<dvec2> uv;
  for (int step = 0; step < kMostSteps && !open.empty(); ++step) {
    uv.clear();
    for (RootSearch& search : open) {
      search.choose(step);
      const LevelBracket& bracket = brackets[search.index];
      uv.push_back(glm::mix(bracket.from, bracket.to, search.next));
    }
    const std::vector<double> numbers = evaluate_color(surface, uv, threads);
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      LevelBracket& bracket = brackets[open[k].index];
      const double value = numbers[k] - bracket.level;
      if (std::isnan(value)) {
        bracket.is_jump = true;
        continue;
      }
      open[k].take(value);
      if (!is_found(open[k], bracket)) open[kept++] = open[k];
    }
    open.resize(kept);
  }
}

}  // namespace saddle
