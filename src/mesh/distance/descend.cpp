#include "mesh/distance/descend.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <glm/common.hpp>

#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

struct Descent {
  dvec2 uv{0};
  SurfacePoint at = {};
  double distance = std::numeric_limits<double>::infinity();
  /// The part of the normal equations' diagonal that is added to it. A step that comes no nearer
  /// multiplies it by 10, another one by 0.1.
  double damping = kNearly;
  /// Whether a step that was hardly damped came no nearer than by a share of kOfSecondOrder.
  bool has_settled = false;
};

dvec2 step(const Descent& d, const dvec3& from) {
  const dvec3 gap = from - d.at.position;
  const double a = (1 + d.damping) * glm::dot(d.at.r_u, d.at.r_u);
  const double b = glm::dot(d.at.r_u, d.at.r_v);
  const double c = (1 + d.damping) * glm::dot(d.at.r_v, d.at.r_v);
  const dvec2 right(glm::dot(d.at.r_u, gap), glm::dot(d.at.r_v, gap));
  const dvec2 way = dvec2(c * right.x - b * right.y, a * right.y - b * right.x) / (a * c - b * b);
  return std::isfinite(way.x + way.y) ? way : dvec2(0);
}

/// Takes a place if it is nearer; else raises the damping.
void arrive(const dvec2& uv, const SurfacePoint& there, const dvec3& from, Descent& d) {
  const double distance = glm::distance(there.position, from);
  if (distance < d.distance) {
    const bool has_settled = d.damping <= kNearly && distance > (1 - kOfSecondOrder) * d.distance;
    d = {uv, there, distance, 0.1 * d.damping, has_settled};
  } else {
    d.damping *= 10;
  }
}

}  // namespace

std::vector<PlacedError> descend(const Surface& surface, std::span<const Descending> points,
                                 int steps, unsigned threads) {
  std::vector<Descent> descents(points.size());
  std::vector<std::size_t> active(points.size());  // numbers of descents
  std::iota(active.begin(), active.end(), std::size_t{0});
  std::vector<dvec2> uv;
  for (const Descending& point : points) uv.push_back(point.start);
  for (int round = 0; round <= steps && !active.empty(); ++round) {
    const std::vector<SurfacePoint> there = evaluate(surface, uv, threads);
    for (std::size_t i = 0; i < active.size(); ++i)
      arrive(uv[i], there[i], points[active[i]].from, descents[active[i]]);
    std::erase_if(active, [&](std::size_t k) {
      return descents[k].has_settled || descents[k].distance <= points[k].enough;
    });
    uv.clear();
    for (const std::size_t k : active) {
      const Descent& d = descents[k];
      uv.push_back(nearest_in(points[k].within, d.uv + step(d, points[k].from)));
    }
  }
  std::vector<PlacedError> nearest;
  nearest.reserve(descents.size());
  for (const Descent& d : descents) nearest.push_back({d.distance, d.uv});
  return nearest;
}

}  // namespace saddle
