// Boxes and lines of parameters.
#pragma once

#include <array>
#include <vector>

#include <glm/common.hpp>

#include "base/vec.h"
#include "surface/surface.h"

namespace saddle {

/// A rectangle of parameters; `low` may be the larger where a range runs backwards.
struct ParameterBox {
  dvec2 low, high;
  dvec2 middle() const { return 0.5 * low + 0.5 * high; }
  dvec2 size() const { return glm::abs(high - low); }
};

/// The box around a triangle of places.
inline ParameterBox box_around(const std::array<dvec2, 3>& corners) {
  const auto& [a, b, c] = corners;
  return {glm::min(a, glm::min(b, c)), glm::max(a, glm::max(b, c))};
}

/// The place in a box that is nearest to a place.
inline dvec2 nearest_in(const ParameterBox& box, const dvec2& uv) {
  return glm::clamp(uv, glm::min(box.low, box.high), glm::max(box.low, box.high));
}

/// The whole domain, in its direction.
inline ParameterBox box_of(const Domain& domain) {
  return {{domain.u0, domain.v0}, {domain.u1, domain.v1}};
}

/// Whether a line of constant u or v is on the edge of a domain.
inline bool is_on_edge(const std::array<dvec2, 2>& line, const ParameterBox& domain) {
  const auto is_on_side = [&](int axis) {
    const double at = line[0][axis];
    return at == line[1][axis] && (at == domain.low[axis] || at == domain.high[axis]);
  };
  return is_on_side(0) || is_on_side(1);
}

/// The halves of a box along u (axis 0) or v (axis 1), which share its middle line.
inline std::array<ParameterBox, 2> halves_of(const ParameterBox& box, int axis) {
  std::array<ParameterBox, 2> halves = {box, box};
  halves[0].high[axis] = halves[1].low[axis] = box.middle()[axis];
  return halves;
}

/// `cells` + 1 evenly spaced parameters, both ends exact.
std::vector<double> even_lines(double first, double last, std::size_t cells);

}  // namespace saddle
