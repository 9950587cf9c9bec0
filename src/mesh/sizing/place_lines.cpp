#include "mesh/sizing/place_lines.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {
namespace {

/// Cells between two fixed lines. Rounding of the sums adds none to a whole number.
double cells_between(const Cumulative& cumulative, double a, double b) {
  const double cells = std::ceil(cumulative.at(b) - cumulative.at(a) - kSame);
  return std::clamp(std::isfinite(cells) ? cells : 1.0, 1.0, static_cast<double>(kMostGridCells));
}

}  // namespace

Cumulative::Cumulative(std::span<const double> density, double first, double last)
    : first_(first), last_(last), sums_(1, 0.0) {
  const double stretch = std::fabs(last - first) / static_cast<double>(density.size());
  sums_.reserve(density.size() + 1);
  for (const double d : density) sums_.push_back(sums_.back() + d * stretch);
}

double Cumulative::at(double parameter) const {
  const double part = (parameter - first_) / (last_ - first_) * static_cast<double>(count());
  const auto i = static_cast<std::size_t>(std::clamp(part, 0.0, static_cast<double>(count())));
  if (i >= count()) return sums_.back();
  return std::lerp(sums_[i], sums_[i + 1], part - static_cast<double>(i));
}

double Cumulative::where(double lines) const {
  const auto above = std::ranges::upper_bound(sums_, lines);
  const auto i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(above - sums_.begin(), 1, std::ssize(sums_) - 1));
  const double step = sums_[i] - sums_[i - 1];
  const double within = step > 0 ? (lines - sums_[i - 1]) / step : 0.5;
  const double part = (static_cast<double>(i - 1) + within) / static_cast<double>(count());
  return first_ * (1 - part) + last_ * part;
}

double total_cells(const Cumulative& cumulative, std::span<const double> fixed) {
  double sum = 0;
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
    sum += cells_between(cumulative, fixed[k], fixed[k + 1]);
  }
  return sum;
}

namespace {

/// Lines of the first of `parts` equal parts of a range, and their copies in the others.
std::vector<double> repeated(const std::vector<double>& first_part, double range, unsigned parts) {
  std::vector<double> lines;
  for (unsigned part = 0; part < parts; ++part) {
    for (std::size_t k = 0; k + 1 < first_part.size(); ++k) {
      lines.push_back(first_part[k] + range * part / parts);
    }
  }
  lines.push_back(first_part.front() + range);
  return lines;
}

}  // namespace

std::vector<double> place_between(const Cumulative& cumulative, std::span<const double> fixed,
                                  const Seam& seam) {
  const unsigned parts = seam.shift.of;
  if (parts == 1 || (fixed.size() - 1) % parts != 0) return place_between(cumulative, fixed);
  const std::size_t cells = (fixed.size() - 1) / parts;
  return repeated(place_between(cumulative, fixed.first(cells + 1)), fixed.back() - fixed.front(),
                  parts);
}

std::vector<double> place_between(const Cumulative& cumulative, std::span<const double> fixed) {
  std::vector<double> lines;
  for (std::size_t k = 0; k + 1 < fixed.size(); ++k) {
    lines.push_back(fixed[k]);
    const double cells = cells_between(cumulative, fixed[k], fixed[k + 1]);
    const double first = cumulative.at(fixed[k]);
    const double step = (cumulative.at(fixed[k + 1]) - first) / cells;
    for (double c = 1; c < cells; ++c) {
      const double line = cumulative.where(first + c * step);
      const double even = std::lerp(fixed[k], fixed[k + 1], c / cells);
      const bool inside = (line - fixed[k]) * (line - fixed[k + 1]) < 0 && line != lines.back();
      lines.push_back(inside && step > 0 ? line : even);
    }
  }
  lines.push_back(fixed.back());
  return lines;
}

std::vector<double> shared_lines(const Seam& seam, const std::vector<double>& fixed) {
  const std::size_t cells = fixed.size() - 1;
  const std::size_t shared = std::lcm(cells, std::size_t{seam.shift.of});
  return shared == cells ? fixed : even_lines(fixed.front(), fixed.back(), shared);
}

std::vector<double> with_lines(std::vector<double> fixed, const std::vector<double>& more,
                               const Seam& seam, const std::array<bool, 2>& folded) {
  const double first = fixed.front();
  const double range = fixed.back() - first;
  const auto add = [&](double line) {
    const auto is_same = [&](double other) {
      return std::fabs(other - line) <= kNearly * std::fabs(range);
    };
    if (std::ranges::none_of(fixed, is_same)) fixed.push_back(line);
  };
  for (const double line : more) {
    const double part = (line - first) / range;
    add(line);
    if (seam.reversed) add(first + range * seam.partner(part, 1.0));
    for (unsigned k = 1; k < seam.shift.of; ++k) {
      add(first + range * Shift{k, seam.shift.of}(part, 1.0));
    }
    if (folded[0] || folded[1]) add(first + range * kFold.partner(part, 1.0));
  }
  std::ranges::sort(fixed, {}, [&](double line) { return (line - first) / range; });
  return fixed;
}

}  // namespace saddle
