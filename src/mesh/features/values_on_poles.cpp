#include "mesh/features/values_on_poles.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/approach.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"
#include "surface/parameter_box.h"
#include "surface/surface_enclosure.h"

namespace saddle {

bool may_have_values_on_poles(const Surface& surface) {
  const auto is_condition = [](const Instruction& step) {
    return step.op == Op::Select || step.op == Op::Equal || step.op == Op::NotEqual;
  };
  const Tape& tape = surface.positions;
  const bool has_condition = std::ranges::any_of(tape.of_u, is_condition) ||
                             std::ranges::any_of(tape.of_v, is_condition) ||
                             std::ranges::any_of(tape.of_both, is_condition);
  if (!has_condition) return false;
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  return std::ranges::any_of(enclosure.enclose(box_of(surface.domain)), [](const Interval& a) {
    return !std::isfinite(a.low) || !std::isfinite(a.high);
  });
}

std::vector<bool> are_on_poles(const Surface& surface, std::span<const dvec2> places,
                               std::span<const dvec3> positions, double delta, unsigned threads,
                               std::size_t& work) {
  const ParameterBox domain = box_of(surface.domain);
  const dvec2 aslant(0.13, 0.37);  // along axes and diagonals formulas often have special values
  std::vector<dvec2> beside;
  for (const dvec2& place : places)
    beside.push_back(place + kNearly * (domain.middle() - place + aslant * domain.size()));
  const std::vector<dvec3> near = evaluate_positions(surface, beside, threads);
  std::vector<std::size_t> steep;
  std::vector<Line> ways;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!is_finite(positions[k]) || glm::distance(positions[k], near[k]) <= delta) continue;
    // Doubles may miss a pole: tan(pi/2) is 1.6e16.
    if (safe_length(positions[k]) > safe_length(near[k])) continue;
    steep.push_back(k);
    for (const dvec2& way : kFourWays)
      ways.push_back({places[k], places[k] + 0.25 * domain.size() * (way + aslant)});
  }
  const std::vector<bool> far = diverge(surface, ways, delta, threads);
  work += beside.size() + kApproach.size() * ways.size();
  std::vector<bool> result(places.size(), false);
  for (std::size_t i = 0; i < steep.size(); ++i) {
    const auto first = far.begin() + static_cast<std::ptrdiff_t>(kFourWays.size() * i);
    const auto count = std::count(first, first + kFourWays.size(), true);
    result[steep[i]] = 2 * count >= std::ssize(kFourWays);
  }
  return result;
}

}  // namespace saddle
