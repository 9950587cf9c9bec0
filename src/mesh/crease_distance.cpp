#include "mesh/crease_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

namespace saddle {

namespace {

/// Halvings of a line on the way to its cusp: a four thousandth of it is enough for a distance,
/// which is of second order.
constexpr int kHalvings = 12;
/// Across a cusp normals are opposite, but for how they turn on the way: their cosine is less.
constexpr double kOpposite = -0.7;
/// Steps to the nearest point; and the share of the normal equations' diagonal that is added to it
/// at first, and is ten times as much after a step in vain, a tenth after another.
constexpr int kSteps = 12;
constexpr double kDamping = 1e-4;

dvec3 area_of(const SurfacePoint& p) {
  return glm::cross(p.r_u, p.r_v);
}

std::vector<dvec2> ends_of(std::span<const Line> lines, std::size_t end) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.push_back(line[end]);
  return uv;
}

/// A point of the mesh on its way down to the surface.
struct Descent {
  dvec2 uv;
  SurfacePoint at;
  double distance;
  double damping = kDamping;
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

}  // namespace

std::vector<dvec2> cusp_places(const Surface& surface, std::span<const Line> lines,
                               unsigned threads) {
  std::vector<Line> left(lines.begin(), lines.end());
  const std::vector<SurfacePoint> first = evaluate(surface, ends_of(lines, 0), threads);
  const std::vector<SurfacePoint> second = evaluate(surface, ends_of(lines, 1), threads);
  std::vector<dvec2> middles(lines.size());
  for (int halving = 0; halving < kHalvings; ++halving) {
    for (std::size_t k = 0; k < left.size(); ++k) middles[k] = 0.5 * (left[k][0] + left[k][1]);
    const std::vector<SurfacePoint> points = evaluate(surface, middles, threads);
    for (std::size_t k = 0; k < left.size(); ++k) {
      const dvec3 area = area_of(points[k]);
      const double to_first = glm::dot(area, glm::normalize(area_of(first[k])));
      const double to_second = glm::dot(area, glm::normalize(area_of(second[k])));
      left[k][to_first >= to_second ? 0 : 1] = middles[k];
    }
  }
  std::vector<dvec2> places;
  for (std::size_t k = 0; k < left.size(); ++k) {
    const double cosine =
        glm::dot(glm::normalize(area_of(first[k])), glm::normalize(area_of(second[k])));
    places.push_back(cosine < kOpposite ? left[k][0] : 0.5 * (lines[k][0] + lines[k][1]));
  }
  return places;
}

std::vector<double> distances_from_surface(const Surface& surface,
                                           std::span<const MeshPoint> points, unsigned threads) {
  std::vector<Descent> descents;
  std::vector<dvec2> uv;
  for (const MeshPoint& point : points) {
    descents.push_back({point.uv, {}, std::numeric_limits<double>::infinity()});
    uv.push_back(point.uv);
  }
  for (int round = 0; round <= kSteps; ++round) {
    const std::vector<SurfacePoint> there = evaluate(surface, uv, threads);
    for (std::size_t k = 0; k < points.size(); ++k) {
      Descent& d = descents[k];
      const double distance = glm::distance(there[k].position, points[k].position);
      if (distance < d.distance) {
        d = {uv[k], there[k], distance, 0.1 * d.damping};
      } else {
        d.damping *= 10;
      }
      const dvec2 off = d.uv + step(d, points[k].position) - points[k].uv;
      uv[k] = points[k].uv + glm::clamp(off, -points[k].reach, points[k].reach);
    }
  }
  std::vector<double> distances;
  distances.reserve(descents.size());
  for (const Descent& d : descents) distances.push_back(std::isfinite(d.distance) ? d.distance : 0);
  return distances;
}

}  // namespace saddle
