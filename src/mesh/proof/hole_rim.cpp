#include "mesh/proof/hole_rim.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Shares of a ray that are looked at one after the other: other holes may be behind the nearest
/// edge. kAwayFromPlace tells whether a hole is thin.
constexpr std::array kShares = {1.0 / 64, 1.0 / 32, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0};

/// From an undefined place along one way.
struct Ray {
  dvec2 from, way;
  double undefined = 0;           ///< share of the way up to the last undefined place
  std::optional<double> defined;  ///< up to the first defined place, if it was met

  dvec2 rim() const { return undefined * way; }
};

/// Evaluates the surface at share(ray) of each ray that share() gives a place for.
template <class Share>
void look(const Surface& surface, unsigned threads, Share share, std::vector<Ray>& rays) {
  std::vector<std::size_t> numbers;
  std::vector<double> shares;
  std::vector<dvec2> uv;
  for (std::size_t k = 0; k < rays.size(); ++k) {
    const std::optional<double> at = share(rays[k]);
    if (!at) continue;
    numbers.push_back(k);
    shares.push_back(*at);
    uv.push_back(rays[k].from + *at * rays[k].way);
  }
  const std::vector<dvec3> points = evaluate_positions(surface, uv, threads);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    Ray& ray = rays[numbers[i]];
    if (is_finite(points[i])) {
      ray.defined = shares[i];
    } else {
      ray.undefined = shares[i];
    }
  }
}

/// The part of a way that stays in the domain.
double share_in(const ParameterBox& domain, const dvec2& from, const dvec2& way) {
  double share = 1;
  for (int axis = 0; axis < 2; ++axis) {
    const auto [low, high] = std::minmax(domain.low[axis], domain.high[axis]);
    const double room = (way[axis] < 0 ? low : high) - from[axis];
    if (std::fabs(way[axis]) > std::fabs(room)) share = std::min(share, room / way[axis]);
  }
  return share;
}

/// Eight rays from each place, looked at up to the first defined place.
std::vector<Ray> rays_from(const Surface& surface, std::span<const dvec2> places,
                           const dvec2& reach, std::span<const double> shares, unsigned threads) {
  const ParameterBox domain = box_of(surface.domain);
  std::vector<Ray> rays;
  for (const dvec2& place : places) {
    for (const dvec2& way : kEightWays)
      rays.push_back({place, share_in(domain, place, way * reach) * way * reach, 0, {}});
  }
  for (const double share : shares) {
    const auto next = [share](const Ray& ray) {
      return ray.defined ? std::nullopt : std::optional(share);
    };
    look(surface, threads, next, rays);
  }
  return rays;
}

/// Eight rays from each place, up to their edges.
std::vector<Ray> rays_to_rim(const Surface& surface, std::span<const dvec2> places,
                             const dvec2& reach, unsigned threads) {
  std::vector<Ray> rays = rays_from(surface, places, reach, kShares, threads);
  const auto middle = [](const Ray& ray) {
    return ray.defined ? std::optional(0.5 * (ray.undefined + *ray.defined)) : std::nullopt;
  };
  for (int k = 0; k < kHalvingsToSight; ++k) look(surface, threads, middle, rays);
  return rays;
}

/// The rays of one place: ray k and ray k + 4 make a line through it.
class Rays {
 public:
  explicit Rays(std::span<const Ray> rays) : rays_(rays) {}

  /// The shortest line with an edge at both ends.
  std::optional<std::size_t> shortest(const dvec2& reach) const {
    std::optional<std::size_t> line;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < lines(); ++k) {
      const double length = glm::length((rays_[k].rim() - rays_[k + lines()].rim()) / reach);
      if (!has_edges(k) || length >= least) continue;
      least = length;
      line = k;
    }
    return line;
  }
  /// Whether a line has an edge at both ends.
  bool has_edges(std::size_t line) const {
    return rays_[line].defined && rays_[line + lines()].defined;
  }
  /// From the place to the middle of a line.
  dvec2 to_middle(std::size_t line) const {
    return 0.5 * (rays_[line].rim() + rays_[line + lines()].rim());
  }
  HoleRim rim() const {
    HoleRim rim;
    std::ranges::transform(rays_, rim.begin(), &Ray::rim);
    return rim;
  }

  /// The line across another one.
  static std::size_t across(std::size_t line) { return (line + lines() / 2) % lines(); }
  /// Lines of two rays each.
  static std::size_t lines() { return kEightWays.size() / 2; }

 private:
  std::span<const Ray> rays_;
};

/// Calls f(k, rays of place k).
template <class F>
void for_places(std::span<const Ray> rays, F f) {
  const std::size_t ways = kEightWays.size();
  for (std::size_t k = 0; k * ways < rays.size(); ++k) f(k, Rays(rays.subspan(ways * k, ways)));
}

double distance_from_origin(const dvec3& a, const dvec3& b) {
  const dvec3 along = b - a;
  const double square = glm::dot(along, along);
  const double share = square > 0 ? std::clamp(-glm::dot(a, along) / square, 0.0, 1.0) : 0;
  return glm::length(a + share * along);
}

}  // namespace

std::vector<std::optional<ThinHole>> thin_holes(const Surface& surface,
                                                std::span<const dvec2> undefined,
                                                const dvec2& reach, unsigned threads) {
  std::vector<std::size_t> thin;
  for_places(rays_from(surface, undefined, reach, kAwayFromPlace, threads),
             [&](std::size_t k, const Rays& rays) {
               if (rays.shortest(reach)) thin.push_back(k);
             });
  // Along a slot some stand for all.
  const std::size_t count = std::min(thin.size(), kMostFollowed);
  std::vector<std::size_t> numbers;
  std::vector<dvec2> places;
  for (std::size_t i = 0; i < count; ++i) {
    numbers.push_back(thin[i * thin.size() / count]);
    places.push_back(undefined[numbers.back()]);
  }
  std::vector<std::optional<std::size_t>> lines(places.size());
  for_places(rays_to_rim(surface, places, reach, threads), [&](std::size_t i, const Rays& rays) {
    lines[i] = rays.shortest(reach);
    if (lines[i]) places[i] += rays.to_middle(*lines[i]);
  });
  std::vector<std::optional<ThinHole>> holes(undefined.size());
  std::vector<dvec2> middles = places;
  for_places(rays_to_rim(surface, places, reach, threads), [&](std::size_t i, const Rays& rays) {
    if (lines[i] && rays.has_edges(Rays::across(*lines[i])))
      middles[i] += rays.to_middle(Rays::across(*lines[i]));
  });
  for_places(rays_to_rim(surface, middles, reach, threads), [&](std::size_t i, const Rays& rays) {
    holes[numbers[i]] = {middles[i], rays.rim()};
  });
  return holes;
}

HoleRim rim_of_box(const dvec2& size) {
  HoleRim rim;
  std::ranges::transform(kEightWays, rim.begin(),
                         [&](const dvec2& way) { return 0.5 * size * way; });
  return rim;
}

double depth_of(const HoleRim& rim, const dvec3& r_u, const dvec3& r_v) {
  const auto place = [&](std::size_t k) { return rim[k].x * r_u + rim[k].y * r_v; };
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < rim.size(); ++k)
    depth = std::min(depth, distance_from_origin(place(k), place((k + 1) % rim.size())));
  return depth;
}

}  // namespace saddle
