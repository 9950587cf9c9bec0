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

/// A cell of up to 4 tolerances, or two pixels, is narrow: no wave in it is visible. The image of
/// a parameter range is taken to be as long as the surface's diagonal.
inline constexpr double kNarrow = 4;
/// A leaf predicted to be unresolvable is narrow enough at 1.5 times the width of a narrow one:
/// the narrowest cells of a root grid need no halving.
inline constexpr double kPredictedWidth = 1.5;
/// A cell is unresolvable if it would have to be more than 16 times narrower than a narrow one, 1/4
/// of a tolerance, to be within tolerance. Errors fall with the square of the width.
inline constexpr double kUnresolvable = 16 * 16;
/// Predictions need 4 times the error: they take the largest of a few samples for a whole
/// neighbourhood, a part of which may be resolvable.
inline constexpr double kPredictedUnresolvable = 4 * kUnresolvable;

/// Where cells are predicted to be unresolvable in u, and in v: at kOscillatingShare of the nearest
/// nine samples of a probe, of those that are defined.
class AliasingForecast {
 public:
  /// Predicts none.
  AliasingForecast() = default;
  /// For linearisation errors of narrow cells: those above kPredictedUnresolvable are unresolvable.
  explicit AliasingForecast(LinearizationErrors linearization_errors);

  bool any() const { return !is_unresolvable_.empty(); }
  glm::bvec2 at(const dvec2& uv) const;

 private:
  glm::bvec2 around(const LinearizationErrors& linearization_errors, std::size_t column,
                    std::size_t row) const;

  std::vector<double> u_, v_;
  std::vector<glm::bvec2> is_unresolvable_;  // v outer; empty if there are none
};

/// Whether an area of a surface is predicted to oscillate, so that no mesh keeps the tolerance.
bool foresees_aliasing(const Probe& probe, const Tolerance& tolerance);

}  // namespace saddle
