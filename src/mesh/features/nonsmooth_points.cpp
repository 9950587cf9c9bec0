#include "mesh/features/nonsmooth_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/features/point_singularities.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/box_groups.h"
#include "mesh/proof/certify.h"
#include "surface/box_subdivision.h"
#include "surface/normal.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Searches: a point takes about 600 boxes down to its doubles.
constexpr std::size_t kSearchesForPoints = 4;

/// Leaves out the largest groups of boxes that touch: they lie along curves. Four boxes meet at a
/// point on their corners; along a curve their number doubles every two levels.
void keep_points(std::vector<ParameterBox>& boxes) {
  const std::vector<std::uint32_t> groups = groups_of(boxes);
  std::vector<std::pair<std::ptrdiff_t, std::uint32_t>> sizes;  // of the group of each box
  sizes.reserve(groups.size());
  for (const std::uint32_t group : groups)
    sizes.emplace_back(std::ranges::count(groups, group), group);
  std::vector<std::pair<std::ptrdiff_t, std::uint32_t>> sorted = sizes;
  std::ranges::sort(sorted);
  std::vector<ParameterBox> kept;
  for (std::size_t k = 0; k < boxes.size(); ++k) {
    if (sizes[k] < sorted[kMostFollowed]) kept.push_back(boxes[k]);
  }
  boxes = std::move(kept);
}

/// The smallest boxes in which tangents are not proved to be continuous, but for those on curves:
/// none if they are not as small as points.
std::vector<ParameterBox> nonsmooth_boxes(const Surface& surface) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  std::size_t budget = kSearchesForPoints * ProofBudget(surface.bounds).boxes_of_search();
  BoxSubdivision<ParameterBox> search(std::vector{box_of(surface.domain)});
  while (!search.open().empty() && search.depth() < 2 * kAllHalvings) {
    const bool are_points = search.depth() >= 2 * kHalvingsToSame;
    if (budget < search.open().size())
      return are_points ? search.open() : std::vector<ParameterBox>{};
    budget -= search.open().size();
    search.test([&](const ParameterBox& box) {
      return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
    });
    if (search.open().size() > kMostFollowed && !are_points) keep_points(search.open());
    search.halve_in_turn(AtLastDigit::Keep);
  }
  return search.open();
}

/// Candidates for a coordinate of the point in a box, the best last.
std::vector<double> coordinates(double low, double high, double range) {
  std::vector<double> all = {low, high};
  if (std::min(std::fabs(low), std::fabs(high)) <= kRounding * range) all.push_back(0);
  return all;
}

/// Appends places between neighbouring doubles, one for boxes that touch: all doubles beside a
/// point such as that of hypot(u^2 - 2, v) have tangents. `known`: points that were found.
void append_between_doubles(std::span<const ParameterBox> boxes, const dvec2& range,
                            std::span<const dvec2> known, std::vector<dvec2>& places) {
  for (const auto& [low, high] : boxes) {
    const dvec2 uv(coordinates(low.x, high.x, range.x).back(),
                   coordinates(low.y, high.y, range.y).back());
    const auto is_there = [&](const dvec2& other) {
      return glm::length((uv - other) / range) < kNearly;
    };
    if (std::ranges::none_of(known, is_there) && std::ranges::none_of(places, is_there))
      places.push_back(uv);
  }
}

}  // namespace

NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads) {
  const dvec2 range = box_of(surface.domain).size();
  const std::vector<ParameterBox> boxes = nonsmooth_boxes(surface);
  std::vector<dvec2> places;
  for (const ParameterBox& box : boxes) {
    for (const double u : coordinates(box.low.x, box.high.x, range.x)) {
      for (const double v : coordinates(box.low.y, box.high.y, range.y)) {
        if (std::ranges::count(places, dvec2(u, v)) == 0) places.emplace_back(u, v);
      }
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, places, threads);
  NonsmoothPoints rough;
  std::vector<dvec2> unclear;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool has_tangents = is_finite(points[k].r_u) && is_finite(points[k].r_v);
    if (!is_finite(points[k].position)) {
      unclear.push_back(places[k]);
    } else if (!has_tangents) {
      rough.conical.push_back(places[k]);
    }
  }
  const std::size_t undefined = unclear.size();
  append_between_doubles(boxes, range, rough.conical, unclear);
  const std::vector<PointSingularity> singularities =
      classify_points(surface, unclear, diagonal, threads);
  for (std::size_t k = 0; k < unclear.size(); ++k) {
    // Between doubles, a vertex would have any of the values around the point.
    if (singularities[k].kind == PointSingularity::Kind::Essential && k < undefined)
      rough.without_limit.push_back(unclear[k]);
    const bool is_filled = singularities[k].kind == PointSingularity::Kind::Removable;
    if (is_filled && normals_around(surface, unclear[k]).size() > 1)
      rough.conical.push_back(unclear[k]);
  }
  return rough;
}

}  // namespace saddle
