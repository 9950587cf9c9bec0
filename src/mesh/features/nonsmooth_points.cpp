#include "mesh/features/nonsmooth_points.h"

#include <algorithm>
#include <cmath>

#include "mesh/features/point_singularities.h"
#include "mesh/proof/certify.h"
#include "surface/box_subdivision.h"
#include "surface/normal.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Halvings of the domain each way: to neighbours in double precision.
constexpr int kDomainHalvings = 60;
/// Open boxes of a level. Four meet at a point on their corners; along a line there are more.
constexpr std::size_t kMostBoxes = 64;
/// The search has a third of the budget of proofs.
constexpr std::size_t kProofsPerBox = 3;
/// In ranges: a coordinate this near to 0 may be 0.
constexpr double kNearZero = 0x1p-50;

/// The smallest boxes in which tangents are not proved to be continuous; none if they are many.
std::vector<ParameterBox> nonsmooth_boxes(const Surface& surface) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  const SubdivisionLimits limits = {
      .boxes = ProofBudget(surface.bounds).boxes_of_search() / kProofsPerBox,
      .halvings = 2 * kDomainHalvings,
      .most_open = kMostBoxes,
  };
  const auto search = subdivide(box_of(surface.domain), limits, [&](const ParameterBox& box) {
    return are_continuous(enclosure.enclose(box)) ? ProofOutcome::Proved : ProofOutcome::Open;
  });
  if (search.depth() < limits.halvings) return {};
  return search.open();
}

/// Candidates for a coordinate of the point in a box.
std::vector<double> coordinates(double low, double high, double range) {
  std::vector<double> all = {low, high};
  if (std::min(std::fabs(low), std::fabs(high)) <= kNearZero * range) all.push_back(0);
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
