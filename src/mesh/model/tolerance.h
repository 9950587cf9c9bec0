// The tolerance: the largest distance of mesh and surface that is allowed.
#pragma once

#include <algorithm>
#include <concepts>
#include <functional>
#include <optional>
#include <utility>

#include "base/bounds.h"
#include "base/vec.h"

namespace saddle {

/// A length above 0, the same everywhere or a function of the place. The tolerance of a leaf is
/// the least in the ball around it: `place` is the centre, `reach` the radius.
class Tolerance {
 public:
  /// The same everywhere.
  Tolerance(double same) : same_(same) {}

  /// From a function of place and reach, or of the place alone.
  template <std::invocable<const dvec3&, double> Function>
  Tolerance(Function function) : near_(std::move(function)) {}
  template <std::invocable<const dvec3&> Function>
  Tolerance(Function function)
      : near_([function = std::move(function)](const dvec3& place, double) {
          return function(place);
        }) {}

  double operator()(const dvec3& place, double reach = 0) const {
    return same_ ? *same_ : near_(place, reach);
  }

  /// The least of a whole surface within these bounds, as a share of their diagonal.
  double share_of_diagonal(const Bounds& bounds) const {
    const double diagonal = bounds.diagonal();
    return (*this)(bounds.centre(), diagonal) / diagonal;
  }

  bool is_same_everywhere() const { return same_.has_value(); }

  /// This tolerance times a factor.
  Tolerance times(double factor) const {
    if (same_) return factor * *same_;
    return [factor, near = near_](const dvec3& place, double reach) {
      return factor * near(place, reach);
    };
  }

  /// The larger of this tolerance and a length.
  Tolerance at_least(double length) const {
    if (same_) return std::max(*same_, length);
    return [length, near = near_](const dvec3& place, double reach) {
      return std::max(near(place, reach), length);
    };
  }

  /// The smaller of this tolerance and a length.
  Tolerance at_most(double length) const {
    if (same_) return std::min(*same_, length);
    return [length, near = near_](const dvec3& place, double reach) {
      return std::min(near(place, reach), length);
    };
  }

 private:
  std::optional<double> same_;
  std::function<double(const dvec3&, double)> near_;
};

}  // namespace saddle
