#include "surface/parameter_box.h"

#include <cmath>

namespace saddle {

std::vector<double> even_lines(double first, double last, std::size_t cells) {
  std::vector<double> values(cells + 1);
  const auto n = static_cast<double>(cells);
  for (std::size_t i = 0; i < cells; ++i) {
    // Weighting the ends, rather than stepping from the first, makes symmetric ranges symmetric to
    // the last bit and hits 0 where it is a line.
    const auto k = static_cast<double>(i);
    const double value = (first * (n - k) + last * k) / n;
    values[i] = std::isfinite(value) ? value : std::lerp(first, last, k / n);
  }
  values.front() = first;
  values.back() = last;
  return values;
}

}  // namespace saddle
