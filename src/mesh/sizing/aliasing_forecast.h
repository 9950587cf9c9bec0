// Predicts, before there is a mesh, where a surface is unresolvable (aliased): waves too short for
// any mesh within the limits.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec2.hpp>

#include "mesh/sizing/probe.h"

namespace saddle {

/// A surface oscillates where cells are unresolvable over more than this share of an area: second
/// derivatives of waves are small between their crests, and along a line a tenth of the cells fail.
inline constexpr double kOscillatingShare = 0.4;

/// Where cells are predicted to be unresolvable in u, and in v: at kOscillatingShare of the nearest
/// nine samples of a probe, of those that are defined.
class AliasingForecast {
 public:
  /// Predicts none.
  AliasingForecast() = default;
  /// A cell is unresolvable at a sample whose linearisation error exceeds `unresolvable`, in
  /// tolerances.
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
