#include "mesh/color/color_limit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/model/tolerances.h"
#include "surface/limit_path.h"

namespace saddle {

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
  if (!(best_change <= kLimitsAgree * std::abs(best))) return std::nullopt;
  return best;
}

}  // namespace saddle
