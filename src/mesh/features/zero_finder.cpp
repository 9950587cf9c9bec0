#include "mesh/features/zero_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// After the first 3 steps, a step that leaves more than half of |r_u x r_v| ends the descent:
/// there is no zero.
constexpr int kFirstDescents = 3;
constexpr double kLeaves = 0.5;
/// |r_u x r_v| is 0 if it is at most kNearly of its largest value 1e-4 ranges away. Double zeros,
/// which are known to 1e-8, have 1e-8 of it.
constexpr double kAroundZero = 1e-4;

}  // namespace

ZeroFinder::ZeroFinder(const Surface& surface, const Bounds& bounds, unsigned threads,
                       std::span<const double> even_u, std::span<const double> even_v)
    : surface_(surface), threads_(threads), scale_(axis_scale(bounds)) {
  const Domain& d = surface.domain;
  low_ = {d.u0, d.v0};
  range_ = {d.u1 - d.u0, d.v1 - d.v0};
  for (const double u : even_u) even_[0].push_back(part({u, 0}).x);
  for (const double v : even_v) even_[1].push_back(part({0, v}).y);
}

UnitPlaces ZeroFinder::parts(std::span<const dvec2> uv) const {
  UnitPlaces parts;
  for (const dvec2& place : uv) parts.push_back(part(place));
  return parts;
}

UnitPlaces ZeroFinder::descend(UnitPlaces places, Along along) const {
  std::vector<double> left(places.size(), std::numeric_limits<double>::infinity());
  std::vector<std::size_t> going(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    places[k] = clamped(places[k]);
    going[k] = k;
  }
  // From a sample beside a simple or a double zero five steps are enough; at other zeros each
  // leaves a third or a half of the way.
  for (int step = 0; step < kAllHalvings && !going.empty(); ++step) {
    UnitPlaces from;
    for (const std::size_t k : going) from.push_back(places[k]);
    const UnitPlaces ways = ways_down(from, along);
    UnitPlaces trials;
    for (std::size_t i = 0; i < going.size(); ++i) {
      trials.push_back(clamped(from[i] + ways[i]));
      trials.push_back(clamped(from[i] + 2.0 * ways[i]));
    }
    const std::vector<double> sizes = sizes_at(trials);
    std::vector<std::size_t> still;
    for (std::size_t i = 0; i < going.size(); ++i) {
      const std::size_t best = 2 * i + (sizes[2 * i + 1] < sizes[2 * i] ? 1 : 0);
      places[going[i]] = trials[best];
      double& size = left[going[i]];
      const bool comes_down = step < kFirstDescents || sizes[best] < kLeaves * size;
      size = sizes[best];
      if (comes_down && size > 0 && glm::distance(trials[best], from[i]) > kRounding) {
        still.push_back(going[i]);
      }
    }
    going = std::move(still);
  }
  return places;
}

std::vector<double> ZeroFinder::sizes_at(const UnitPlaces& places) const {
  UnitPlaces uv;
  uv.reserve(places.size());
  for (const dvec2& place : places) uv.push_back(parameters(place));
  std::vector<double> sizes;
  sizes.reserve(places.size());
  for (const SurfacePoint& p : evaluate(surface_, uv, threads_)) {
    const double size = glm::length(glm::cross(scale_ * p.r_u, scale_ * p.r_v));
    const bool is_known = is_finite(p.position) && std::isfinite(size);
    sizes.push_back(is_known ? size : std::numeric_limits<double>::infinity());
  }
  return sizes;
}

std::vector<bool> ZeroFinder::are_zeros(const UnitPlaces& places) const {
  UnitPlaces around;
  for (const dvec2& place : places) {
    for (const dvec2& way : ways()) around.push_back(place + kAroundZero * way);
  }
  const std::vector<double> sizes = sizes_at(places);
  const std::vector<double> beside = sizes_at(around);
  std::vector<bool> are;
  for (std::size_t k = 0; k < places.size(); ++k) {
    double largest = 0;
    for (std::size_t w = 0; w < kWaysAround; ++w) {
      const double size = beside[k * kWaysAround + w];
      if (std::isfinite(size)) largest = std::max(largest, size);
    }
    are.push_back(largest > 0 && sizes[k] <= kNearly * largest);
  }
  return are;
}

UnitPlaces ZeroFinder::zeros(const UnitPlaces& places) const {
  UnitPlaces even = places;
  for (dvec2& place : even) {
    for (int axis = 0; axis < 2; ++axis) {
      for (const double at : even_[axis]) {
        if (std::fabs(at - place[axis]) <= kNearly) place[axis] = at;
      }
    }
  }
  const std::vector<bool> are = are_zeros(places);
  UnitPlaces zeros;
  UnitPlaces evened;
  std::vector<std::size_t> numbers;  // of those, among the zeros
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!are[k]) continue;
    if (even[k] != places[k]) {
      evened.push_back(even[k]);
      numbers.push_back(zeros.size());
    }
    zeros.push_back(places[k]);
  }
  const std::vector<bool> are_even = are_zeros(evened);
  for (std::size_t i = 0; i < evened.size(); ++i) {
    if (are_even[i]) zeros[numbers[i]] = evened[i];
  }
  return zeros;
}

std::vector<bool> ZeroFinder::stand_alone(const UnitPlaces& places) const {
  UnitPlaces beside;
  for (const dvec2& place : places) beside.push_back(clamped(place + kBesideZero * ways()[0]));
  const std::vector<Area> here = areas_at(places);
  const std::vector<Area> there = areas_at(beside);
  std::vector<bool> do_stand;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const dvec3 normal = glm::cross(here[k].by_u, here[k].by_v);
    const double square = here[k].square();
    // Below kSame, squares of derivatives are rounding; above kNearly, the two derivatives of
    // r_u x r_v are independent.
    do_stand.push_back(square > kSame * there[k].square() &&
                       glm::dot(normal, normal) > kNearly * square * square);
  }
  return do_stand;
}

std::array<dvec2, kWaysAround> ZeroFinder::ways() {
  std::array<dvec2, kWaysAround> ways;
  for (std::size_t k = 0; k < kWaysAround; ++k) {
    const double angle = 2 * std::numbers::pi * (static_cast<double>(k) + 0.3) / kWaysAround;
    ways[k] = {std::cos(angle), std::sin(angle)};
  }
  return ways;
}

double ZeroFinder::Area::square() const {
  return glm::dot(by_u, by_u) + glm::dot(by_v, by_v);
}

dvec2 ZeroFinder::clamped(const dvec2& place) {
  return glm::clamp(place, dvec2(0), dvec2(1));
}

std::vector<ZeroFinder::Area> ZeroFinder::areas_at(const UnitPlaces& places) const {
  UnitPlaces uv;
  uv.reserve(places.size());
  for (const dvec2& place : places) uv.push_back(parameters(place));
  const std::vector<SurfacePoint> first = evaluate(surface_, uv, threads_);
  const std::vector<Curvature> second = evaluate_curvature(surface_, uv, threads_);
  std::vector<Area> areas;
  areas.reserve(places.size());
  for (std::size_t k = 0; k < places.size(); ++k) {
    const dvec3 r_u = scale_ * first[k].r_u;
    const dvec3 r_v = scale_ * first[k].r_v;
    const dvec3 r_uv = scale_ * second[k].r_uv;
    areas.push_back(
        {glm::cross(r_u, r_v),
         range_.x * (glm::cross(scale_ * second[k].r_uu, r_v) + glm::cross(r_u, r_uv)),
         range_.y * (glm::cross(r_uv, r_v) + glm::cross(r_u, scale_ * second[k].r_vv))});
  }
  return areas;
}

/// The shortest ways to zeros of the linear approximations of r_u x r_v.
UnitPlaces ZeroFinder::ways_down(const UnitPlaces& places, Along along) const {
  UnitPlaces ways;
  ways.reserve(places.size());
  for (Area& area : areas_at(places)) {
    if (along == Along::U) area.by_v = dvec3(0);
    if (along == Along::V) area.by_u = dvec3(0);
    ways.push_back(way_down(area));
  }
  return ways;
}

dvec2 ZeroFinder::way_down(const Area& area) {
  const double uu = glm::dot(area.by_u, area.by_u);
  const double uv = glm::dot(area.by_u, area.by_v);
  const double vv = glm::dot(area.by_v, area.by_v);
  const dvec2 slope(glm::dot(area.by_u, area.cross), glm::dot(area.by_v, area.cross));
  const double trace = area.square();
  if (!(trace > 0)) return dvec2(0);
  const double determinant = uu * vv - uv * uv;
  dvec2 way = -slope / trace;
  // A step along a curve of zeros, where the matrix has rank one, goes down the slope alone.
  if (determinant > kSame * trace * trace) {
    way = -dvec2(vv * slope.x - uv * slope.y, uu * slope.y - uv * slope.x) / determinant;
  }
  const double length = glm::length(way);
  if (!std::isfinite(length)) return dvec2(0);
  return length > kFarApart ? way * (kFarApart / length) : way;
}

}  // namespace saddle
