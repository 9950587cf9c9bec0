// Waves too short for any mesh, known before one is made.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "mesh/sizing/probe.h"

namespace saddle {

/// Where narrow cells would be hopeless in u, and in v, by second derivatives at the samples of a
/// probe: at most of the nearest nine.
class AliasingForecast {
 public:
  /// Nothing is foreseen.
  AliasingForecast() = default;
  /// Cells are hopeless at samples at which they depart from their linear approximation by more
  /// than so many tolerances.
  AliasingForecast(LinearizationErrors linearization_errors, double unresolvable);

  bool any() const { return !is_unresolvable_.empty(); }
  glm::bvec2 at(const dvec2& uv) const;

 private:
  glm::bvec2 around(const LinearizationErrors& linearization_errors, std::size_t column,
                    std::size_t row, double unresolvable) const;

  std::vector<double> u_, v_;
  std::vector<glm::bvec2> is_unresolvable_;  // v outer; empty if there are none
};

}  // namespace saddle
