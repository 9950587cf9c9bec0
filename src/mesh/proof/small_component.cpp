// component_of() of landmarks.h.
#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/common.hpp>

#include "base/random.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/landmarks.h"

namespace saddle {

namespace {

/// In sizes of the box around landmarks: the margin of a component on each side.
constexpr double kComponentMargin = 0.5;

}  // namespace

std::optional<SmallComponent> component_of(const Landmarks& landmarks, std::span<const dvec2> met,
                                           const Surface& surface, unsigned threads) {
  if (std::ranges::all_of(landmarks.places, &Landmark::is_hole)) return std::nullopt;
  const Domain& d = surface.domain;
  const dvec2 least = glm::min(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  const dvec2 most = glm::max(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  // The component may reach into the boxes beside those in which it was found.
  auto [low, high] = landmarks.around;
  for (const dvec2& uv : met) {
    low = glm::min(low, uv);
    high = glm::max(high, uv);
  }
  const dvec2 margin = kComponentMargin * (high - low);
  SmallComponent component{{glm::max(least, low - margin), glm::min(most, high + margin)}, {}};
  low = component.where.low;
  high = component.where.high;
  // Rows begin at places of their own: no two points of a strip along u or v are at one place of
  // it.
  std::vector<dvec2> places;
  for (std::uint64_t j = 0; j <= kDomainParts; ++j) {
    for (std::uint64_t i = 0; i <= kDomainParts; ++i) {
      const dvec2 part = dvec2(i, j) + dvec2(random_unit(2 * j), random_unit(2 * i + 1));
      places.push_back(glm::mix(low, high, part / (kDomainParts + 1.0)));
    }
  }
  Bounds around;
  for (const SurfacePoint& point : evaluate(surface, places, threads)) {
    if (!is_finite(point.position)) continue;
    component.positions.push_back(point.position);
    around.add(point.position);
  }
  // Landmarks crowd: they stand for the surface only where those points do not meet it.
  const bool is_met = component.positions.size() > kDomainParts;
  for (const Landmark& landmark : landmarks.places) {
    if (landmark.is_hole() || (is_met && around.contains(landmark.position))) continue;
    component.positions.push_back(landmark.position);
  }
  return component;
}

}  // namespace saddle
