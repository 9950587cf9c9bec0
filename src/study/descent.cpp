#include "study/descent.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "base/random.h"

namespace saddle {
namespace {

/// Steps of a descent.
constexpr int kDescents = 12;
/// Halvings of a way to a place where the surface is not defined.
constexpr int kHalvings = 40;
/// Starts of a second try: the nearest known point, three corners, and places in all directions.
constexpr std::size_t kDirections = 8;
constexpr std::size_t kSecondStarts = 4 + kDirections;
/// Steps of a search; the factors of a step's length after a step that helped, and after one that
/// did not.
constexpr std::size_t kSearches = 60;
constexpr double kLonger = 1.5;
constexpr double kShorter = 0.6;
constexpr std::uint64_t kSearchSeed = 0x5eed;

/// The size of the box around a triangle, in parameters.
dvec2 size_of(const std::array<dvec2, 3>& corners) {
  const auto& [a, b, c] = corners;
  return glm::max(glm::max(a, b), c) - glm::min(glm::min(a, b), c);
}

/// Ways from a place evenly around it.
dvec2 way_around(std::size_t way, double turn) {
  const double angle = 2 * std::numbers::pi * (static_cast<double>(way) + turn) / kDirections;
  return {std::cos(angle), std::sin(angle)};
}

/// Where the next step leads: the least squares of r(u, v) = from, within the domain.
dvec2 step(const Descent& d, const Domain& domain) {
  const dvec3 gap = d.from - d.at.position;
  double a = glm::dot(d.at.r_u, d.at.r_u);
  double b = glm::dot(d.at.r_u, d.at.r_v);
  double c = glm::dot(d.at.r_v, d.at.r_v);
  const dvec2 right(glm::dot(d.at.r_u, gap), glm::dot(d.at.r_v, gap));
  a *= 1 + d.damping;
  c *= 1 + d.damping;
  const double determinant = a * c - b * b;
  const dvec2 move = dvec2(c * right.x - b * right.y, a * right.y - b * right.x) / determinant;
  return in_domain(domain, d.uv + move);
}

/// descend() by directions at random, without tangents: at a rim they may be infinite.
void search(const Subject& subject, std::vector<Descent>& points) {
  const Domain& domain = subject.bound.domain;
  const dvec2 size = glm::abs(dvec2(domain.u1 - domain.u0, domain.v1 - domain.v0));
  std::vector<double> reach;  // of each, as a share of the domain
  reach.reserve(points.size());
  for (const Descent& d : points) {
    reach.push_back(glm::length(size_of(d.corners) / size));
  }
  for (std::size_t round = 0; round < kSearches; ++round) {
    std::vector<dvec2> tries;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double turn = random_unit(kSearchSeed + round * points.size() + k);
      for (std::size_t way = 0; way < kDirections; ++way) {
        const dvec2 step = reach[k] * size * way_around(way, turn);
        tries.push_back(in_domain(domain, points[k].uv + step));
      }
    }
    const std::vector<SurfacePoint> there = evaluate(subject.surface, tries, subject.threads);
    for (std::size_t k = 0; k < points.size(); ++k) {
      Descent& d = points[k];
      const double before = d.distance;
      for (std::size_t i = k * kDirections; i < (k + 1) * kDirections; ++i) {
        const double distance = glm::distance(there[i].position, d.from);
        if (!(distance < d.distance)) continue;
        d.uv = tries[i];
        d.distance = distance;
      }
      reach[k] *= d.distance < before ? kLonger : kShorter;
    }
  }
}

/// Where the surface begins on ways to the points' places from all around, kDirections of each; the
/// place itself if it is defined, or the way is not.
std::vector<dvec2> beside_places(const Subject& subject, const std::vector<Descent>& points) {
  std::vector<dvec2> defined, beyond;
  for (const Descent& d : points) {
    for (std::size_t way = 0; way < kDirections; ++way) {
      const dvec2 end = d.place + size_of(d.corners) * way_around(way, 0);
      defined.push_back(in_domain(subject.bound.domain, end));
      beyond.push_back(d.place);
    }
  }
  const std::vector<SurfacePoint> at_ends = evaluate(subject.surface, defined, subject.threads);
  for (std::size_t k = 0; k < defined.size(); ++k) {
    if (!is_finite(at_ends[k].position)) defined[k] = beyond[k];
  }
  std::vector<dvec2> uv = beyond;
  for (int halving = 0; halving <= kHalvings; ++halving) {
    const std::vector<SurfacePoint> there = evaluate(subject.surface, uv, subject.threads);
    for (std::size_t k = 0; k < uv.size(); ++k) {
      (is_finite(there[k].position) ? defined : beyond)[k] = uv[k];
      uv[k] = 0.5 * (defined[k] + beyond[k]);
    }
  }
  return defined;
}

/// Descents of points from elsewhere, kSecondStarts of each: from the nearest of the points that
/// are known of the surface, from the corners of its triangle, and from beside its place, which may
/// be beyond a rim, where tangents lead nowhere.
std::vector<Descent> second_tries(const Subject& subject, const std::vector<Descent>& points,
                                  const std::vector<dvec2>& uv, const std::vector<dvec3>& known) {
  const std::vector<dvec2> beside = beside_places(subject, points);
  std::vector<Descent> tries;
  for (std::size_t k = 0; k < points.size(); ++k) {
    Descent next;
    next.from = points[k].from;
    next.place = points[k].place;
    next.corners = points[k].corners;
    const auto from_it = [&](const dvec3& p) { return glm::distance(p, next.from); };
    const auto nearest = std::ranges::min_element(known, {}, from_it);
    const bool is_known = nearest != known.end();
    std::vector<dvec2> starts = {is_known ? uv[static_cast<std::size_t>(nearest - known.begin())]
                                          : next.place};
    starts.insert(starts.end(), next.corners.begin(), next.corners.end());
    const auto own = std::span(beside).subspan(k * kDirections, kDirections);
    starts.insert(starts.end(), own.begin(), own.end());
    for (const dvec2& start : starts) {
      next.uv = start;
      tries.push_back(next);
    }
  }
  return tries;
}

}  // namespace

dvec2 in_domain(const Domain& d, const dvec2& uv) {
  const auto [u0, u1] = std::minmax(d.u0, d.u1);
  const auto [v0, v1] = std::minmax(d.v0, d.v1);
  return {std::clamp(uv.x, u0, u1), std::clamp(uv.y, v0, v1)};
}

void descend(const Subject& subject, std::vector<Descent>& points) {
  std::vector<dvec2> uv(points.size());
  for (int round = 0; round <= kDescents; ++round) {
    for (std::size_t k = 0; k < points.size(); ++k) {
      uv[k] = round == 0 ? points[k].uv : step(points[k], subject.bound.domain);
      if (!std::isfinite(uv[k].x) || !std::isfinite(uv[k].y)) uv[k] = points[k].uv;
    }
    const std::vector<SurfacePoint> there = evaluate(subject.surface, uv, subject.threads);
    for (std::size_t k = 0; k < points.size(); ++k) {
      Descent& d = points[k];
      const double distance = glm::distance(there[k].position, d.from);
      if (distance < d.distance) {
        d.uv = uv[k];
        d.at = there[k];
        d.distance = distance;
        d.damping *= 0.1;
      } else {
        d.damping = std::max(10 * d.damping, 1e-3);
      }
    }
  }
}

std::vector<double> descend_again(const Subject& subject, const std::vector<Descent>& points,
                                  const std::vector<dvec2>& uv, const std::vector<dvec3>& known) {
  std::vector<Descent> again = second_tries(subject, points, uv, known);
  descend(subject, again);
  search(subject, again);
  std::vector<double> distances;
  for (std::size_t k = 0; k < points.size(); ++k) {
    double distance = points[k].distance;
    for (std::size_t i = k * kSecondStarts; i < (k + 1) * kSecondStarts; ++i) {
      distance = std::min(distance, again[i].distance);
    }
    distances.push_back(distance);
  }
  return distances;
}

}  // namespace saddle
