// The least and the largest coordinates and curvatures of a surface: those that a search finds, and
// bounds of all.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>

#include "base/bounds.h"
#include "surface/surface.h"

namespace saddle {

/// The smallest and the largest of some numbers.
struct Extremes {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  bool empty() const { return low > high; }
  void add(double x) {
    low = x < low ? x : low;
    high = x > high ? x : high;
  }
  void add(const Extremes& other) {
    add(other.low);
    add(other.high);
  }
};

/// The extremes that a search found. Values between them exist; values beyond them may.
struct ValueRange : Extremes {
  /// Proved: it holds all values. Infinite where nothing is proved.
  Extremes bounds;
  /// Places toward which a sequence of values diverges. That end of the range is infinite.
  std::optional<dvec2> falls_toward, grows_toward;
};

/// The quantities of a ValueRanges.
enum Quantity : std::size_t { kX, kY, kZ, kGauss, kMean, kQuantities };
using ValueRanges = std::array<ValueRange, kQuantities>;

/// Branch and bound over boxes of parameters, whose middles are samples beside the `places`; then
/// searches from the best samples. Curvatures are those of regular points.
/// `share`: of the boxes that may be bounded. `within`: points of the surface outside of this box
/// are left out. For a surface of second order. Source: E. Hansen, G. W. Walster, "Global
/// optimization using interval analysis", 2004, chapter 12.
ValueRanges find_extremes(const Surface& surface, std::span<const dvec2> places,
                          const std::optional<Bounds>& within, double share, unsigned threads);

}  // namespace saddle
