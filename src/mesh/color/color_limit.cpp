#include "mesh/color/color_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace saddle {
namespace {

constexpr double kFirstTau = 0.2;
constexpr std::size_t kHighestPower = 6;
/// An extrapolation whose best entry changes by more than this part of it has no limit.
constexpr double kSettled = 1e-4;

}  // namespace

std::array<dvec2, kLimitSteps> limit_path(const dvec2& corner, const dvec2& inside) {
  std::array<dvec2, kLimitSteps> path;
  double tau = kFirstTau;
  for (dvec2& place : path) {
    place = corner + (inside - corner) * (tau * tau);
    tau /= 2;
  }
  return path;
}

std::optional<double> extrapolated_limit(std::span<const double> path) {
  double best = 0;
  double best_change = std::numeric_limits<double>::infinity();
  std::array<double, kHighestPower + 1> previous{};
  std::array<double, kHighestPower + 1> row{};
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!std::isfinite(path[i])) break;
    row[0] = path[i];
    for (std::size_t k = 1; k <= std::min(i, kHighestPower); ++k) {
      const double power = static_cast<double>(1U << k);
      row[k] = row[k - 1] + (row[k - 1] - previous[k - 1]) / (power - 1);
      const double change =
          std::max(std::abs(row[k] - row[k - 1]), std::abs(row[k] - previous[k - 1]));
      if (change < best_change) {
        best = row[k];
        best_change = change;
      }
    }
    previous = row;
  }
  if (!(best_change <= kSettled * std::abs(best))) return std::nullopt;
  return best;
}

}  // namespace saddle
