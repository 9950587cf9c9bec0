#include "mesh/sizing/aliasing_forecast.h"

#include <algorithm>
#include <span>
#include <utility>

#include <glm/vector_relational.hpp>

#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Fewer defined samples of nine count as 5: beside a boundary one or two of few may be where a
/// root is steep. Waves that are undefined in places have about as many.
constexpr double kFewestDefined = 5;

/// The index of the value that is nearest to a parameter, of values in either order.
std::size_t nearest(std::span<const double> values, double parameter) {
  const double way = values.front() > values.back() ? -1 : 1;
  const auto is_before = [&](double value) { return way * value < way * parameter; };
  const auto next = std::ranges::partition_point(values, is_before) - values.begin();
  const auto after = static_cast<std::size_t>(next);
  if (after == 0) return 0;
  if (after == values.size()) return after - 1;
  const bool is_nearer_after =
      way * (values[after] - parameter) < way * (parameter - values[after - 1]);
  return is_nearer_after ? after : after - 1;
}

}  // namespace

AliasingForecast::AliasingForecast(LinearizationErrors linearization_errors)
    : u_(std::move(linearization_errors.u)), v_(std::move(linearization_errors.v)) {
  const auto is_beyond = [&](const dvec2& linearization_error) {
    return glm::any(glm::greaterThan(linearization_error, dvec2(kPredictedUnresolvable)));
  };
  if (std::ranges::none_of(linearization_errors.values, is_beyond)) return;  // as of most surfaces
  const std::size_t columns = u_.size();
  std::vector<glm::bvec2> flags;
  flags.reserve(linearization_errors.values.size());
  for (std::size_t row = 0; row < v_.size(); ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      flags.push_back(around(linearization_errors, column, row));
    }
  }
  const auto is_any = [](const glm::bvec2& flag) { return glm::any(flag); };
  if (std::ranges::any_of(flags, is_any)) is_unresolvable_ = std::move(flags);
}

glm::bvec2 AliasingForecast::around(const LinearizationErrors& linearization_errors,
                                    std::size_t column, std::size_t row) const {
  dvec2 count(0);
  double defined = 0;
  for (std::size_t j = row - std::min<std::size_t>(row, 1); j <= std::min(row + 1, v_.size() - 1);
       ++j) {
    for (std::size_t i = column - std::min<std::size_t>(column, 1);
         i <= std::min(column + 1, u_.size() - 1); ++i) {
      const dvec2& linearization_error = linearization_errors.values[j * u_.size() + i];
      if (glm::any(glm::isnan(linearization_error))) continue;
      ++defined;
      count += dvec2(glm::greaterThan(linearization_error, dvec2(kPredictedUnresolvable)));
    }
  }
  return glm::greaterThan(count, dvec2(kOscillatingShare * std::max(defined, kFewestDefined)));
}

glm::bvec2 AliasingForecast::at(const dvec2& uv) const {
  if (!any()) return glm::bvec2(false);
  return is_unresolvable_[nearest(v_, uv.y) * u_.size() + nearest(u_, uv.x)];
}

bool foresees_aliasing(const Probe& probe, const Tolerance& tolerance) {
  const double narrow = kNarrow * tolerance.share_of_diagonal(probe.bounds());
  const dvec2 size = narrow * box_of(probe.domain()).size();
  return AliasingForecast(probe.linearization_errors(size, tolerance)).any();
}

}  // namespace saddle
