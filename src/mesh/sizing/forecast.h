// Waves too short for any mesh, known before one is made.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "mesh/sizing/density.h"

namespace saddle {

/// Where narrow cells would be hopeless in u, and in v, by second derivatives at the samples of a
/// probe: at most of the nearest nine.
class Forecast {
 public:
  /// Nothing is foreseen.
  Forecast() = default;
  /// Cells are hopeless at samples at which they depart from their linear approximation by more
  /// than so many tolerances.
  Forecast(Departures departures, double hopeless);

  bool any() const { return !is_hopeless_.empty(); }
  glm::bvec2 at(const dvec2& uv) const;

 private:
  glm::bvec2 around(const Departures& departures, std::size_t column, std::size_t row,
                    double hopeless) const;

  std::vector<double> u_, v_;
  std::vector<glm::bvec2> is_hopeless_;  // v outer; empty if there are none
};

}  // namespace saddle
