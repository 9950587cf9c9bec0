#include "mesh/features/nonsmooth_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "eval/enclose.h"
#include "mesh/features/point_singularities.h"
#include "mesh/model/parameter_box.h"
#include "mesh/proof/certify.h"
#include "mesh/proof/small_components.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// r, r_u, r_v.
constexpr std::size_t kOutputs = 9;
/// The domain is halved so many times each way: to neighbours in double precision.
constexpr int kDomainHalvings = 60;
/// Boxes that are followed at a time: four meet at a point on their corners. Along a line there are
/// more.
constexpr std::size_t kMostBoxes = 64;
/// The search may try one box for so many of proofs.
constexpr std::size_t kProofsPerBox = 3;
/// What is this near to 0, in ranges, may be 0.
constexpr double kNearZero = 0x1p-50;

bool is_smooth(Enclosure& enclosure, const ParameterBox& box) {
  std::array<Interval, kOutputs> outputs;
  enclosure(range_between(box.low.x, box.high.x), range_between(box.low.y, box.high.y), outputs);
  return std::ranges::all_of(
      outputs, [](const Interval& a) { return a.defined == Defined::Yes && a.continuous; });
}

/// What is left of the domain where tangents are not proved to be continuous; nothing if that is
/// much.
std::vector<ParameterBox> rough_boxes(const Surface& surface) {
  const Domain& d = surface.domain;
  Enclosure enclosure(surface.bounds, kOutputs);
  std::size_t budget = ProofBudget(surface.bounds).boxes / kProofsPerBox;
  std::vector<ParameterBox> boxes = {{{d.u0, d.v0}, {d.u1, d.v1}}};
  for (int depth = 0; depth < 2 * kDomainHalvings; ++depth) {
    if (boxes.size() > budget) return {};
    budget -= boxes.size();
    std::erase_if(boxes, [&](const ParameterBox& box) { return is_smooth(enclosure, box); });
    if (boxes.empty() || boxes.size() > kMostBoxes) return {};
    std::vector<ParameterBox> halves;
    for (const ParameterBox& box : boxes) {
      const int axis = depth % 2;
      const double middle = box.middle()[axis];
      const bool is_whole = middle == box.low[axis] || middle == box.high[axis];
      ParameterBox first = box;
      ParameterBox second = box;
      if (!is_whole) first.high[axis] = second.low[axis] = middle;
      halves.push_back(first);
      if (!is_whole) halves.push_back(second);
    }
    boxes = std::move(halves);
  }
  return boxes;
}

/// Coordinates that a point in a box may have.
std::vector<double> coordinates(double low, double high, double range) {
  std::vector<double> all = {low, high};
  if (std::min(std::fabs(low), std::fabs(high)) <= kNearZero * range) all.push_back(0);
  return all;
}

}  // namespace

NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads) {
  const Domain& d = surface.domain;
  std::vector<dvec2> places;
  for (const ParameterBox& box : rough_boxes(surface)) {
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
    if (singularities[k].kind == PointSingularity::Kind::NoLimit)
      rough.without_limit.push_back(undefined[k]);
    const bool is_filled = singularities[k].kind == PointSingularity::Kind::Limit;
    if (is_filled && normals_around(surface, undefined[k]).size() > 1)
      rough.conical.push_back(undefined[k]);
  }
  return rough;
}

}  // namespace saddle
