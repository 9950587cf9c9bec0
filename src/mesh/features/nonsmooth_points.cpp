#include "mesh/features/nonsmooth_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "mesh/features/point_singularities.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/box_groups.h"
#include "mesh/proof/certify.h"
#include "surface/box_subdivision.h"
#include "surface/normal.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

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

/// The smallest boxes in which tangents are not proved to be continuous, but for those on curves.
std::vector<ParameterBox> nonsmooth_boxes(const Surface& surface) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  std::size_t budget = ProofBudget(surface.bounds).boxes_of_search();
  BoxSubdivision<ParameterBox> search(std::vector{box_of(surface.domain)});
  while (!search.open().empty() && search.depth() < 2 * kAllHalvings) {
    if (budget < search.open().size()) return {};
    budget -= search.open().size();
    search.test([&](const ParameterBox& box) {
      return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
    });
    if (search.open().size() > kMostFollowed) keep_points(search.open());
    search.halve_in_turn(AtLastDigit::Keep);
  }
  return search.open();
}

/// Candidates for a coordinate of the point in a box.
std::vector<double> coordinates(double low, double high, double range) {
  std::vector<double> all = {low, high};
  if (std::min(std::fabs(low), std::fabs(high)) <= kRounding * range) all.push_back(0);
  return all;
}

}  // namespace

NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads) {
  const Domain& d = surface.domain;
  std::vector<dvec2> places;
  for (const ParameterBox& box : nonsmooth_boxes(surface)) {
    for (const double u : coordinates(box.low.x, box.high.x, std::fabs(d.u1 - d.u0))) {
      for (const double v : coordinates(box.low.y, box.high.y, std::fabs(d.v1 - d.v0))) {
        if (std::ranges::count(places, dvec2(u, v)) == 0) places.emplace_back(u, v);
      }
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, places, threads);
  NonsmoothPoints rough;
  std::vector<dvec2> undefined;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const bool has_tangents = is_finite(points[k].r_u) && is_finite(points[k].r_v);
    if (!is_finite(points[k].position)) {
      undefined.push_back(places[k]);
    } else if (!has_tangents) {
      rough.conical.push_back(places[k]);
    }
  }
  const std::vector<PointSingularity> singularities =
      classify_points(surface, undefined, diagonal, threads);
  for (std::size_t k = 0; k < undefined.size(); ++k) {
    if (singularities[k].kind == PointSingularity::Kind::Essential)
      rough.without_limit.push_back(undefined[k]);
    const bool is_filled = singularities[k].kind == PointSingularity::Kind::Removable;
    if (is_filled && normals_around(surface, undefined[k]).size() > 1)
      rough.conical.push_back(undefined[k]);
  }
  return rough;
}

}  // namespace saddle
