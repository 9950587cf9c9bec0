#include "mesh/features/nonsmooth_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

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

/// For each box, the breaks of the boxes of its group, in order.
class GroupBreaks {
 public:
  GroupBreaks(SurfaceEnclosure& enclosure, std::span<const ParameterBox> boxes)
      : groups_(groups_of(boxes)), breaks_(boxes.size()), of_groups_(boxes.size()) {
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      breaks_[k] = enclosure.count_breaks(boxes[k]);
      of_groups_[groups_[k]].push_back(breaks_[k]);
    }
    for (std::vector<std::size_t>& group : of_groups_) std::ranges::sort(group);
  }
  std::uint32_t group(std::size_t box) const { return groups_[box]; }
  std::size_t size(std::size_t box) const { return of_groups_[groups_[box]].size(); }
  /// Whether a box has more breaks than 3 of 4 boxes of its group: features cross there.
  bool has_many(std::size_t box) const {
    return breaks_[box] > of_groups_[groups_[box]][3 * size(box) / 4];
  }
  /// Whether no box of its group has more.
  bool has_most(std::size_t box) const { return breaks_[box] == of_groups_[groups_[box]].back(); }

 private:
  std::vector<std::uint32_t> groups_;
  std::vector<std::size_t> breaks_;
  std::vector<std::vector<std::size_t>> of_groups_;
};

/// Keeps the boxes whose numbers `is_kept` holds for.
void keep(const auto& is_kept, std::vector<ParameterBox>& boxes) {
  std::size_t number = 0;
  std::erase_if(boxes, [&](const ParameterBox&) { return !is_kept(number++); });
}

/// Leaves out the largest groups of boxes that touch, but for the places where features cross: they
/// lie along curves. Four boxes meet at a point on their corners; along a curve their number
/// doubles every two levels.
void keep_points(SurfaceEnclosure& enclosure, std::vector<ParameterBox>& boxes) {
  const GroupBreaks breaks(enclosure, boxes);
  std::vector<std::pair<std::size_t, std::uint32_t>> sizes;  // of the group of each box
  for (std::size_t k = 0; k < boxes.size(); ++k)
    sizes.emplace_back(breaks.size(k), breaks.group(k));
  std::vector<std::pair<std::size_t, std::uint32_t>> sorted = sizes;
  std::ranges::sort(sorted);
  const auto& first_left_out = sorted[kMostFollowed];
  keep([&](std::size_t k) { return sizes[k] < first_left_out || breaks.has_many(k); }, boxes);
}

/// Leaves out boxes beside points in groups that are as small as points: those along curves that
/// cross there.
void keep_crossings(SurfaceEnclosure& enclosure, std::vector<ParameterBox>& boxes) {
  const GroupBreaks breaks(enclosure, boxes);
  keep([&](std::size_t k) { return breaks.has_most(k); }, boxes);
}

/// A range of one parameter in which an operation breaks.
struct BrokenRange {
  double first, last;
  /// Whether one breaks beyond its ends, in a range that was left out.
  bool before_first = false, beyond_last = false;
  bool is_least = false;  ///< it has been tested, and is not halved any more
};

/// Leaves out the ranges between two others. Where there are many, an operation is undefined all
/// over, and only the ends of them all are lines; at the last doubles the others add no ends.
void keep_ends_of_runs(std::vector<BrokenRange>& ranges) {
  for (std::size_t k = 0; k + 1 < ranges.size(); ++k) {
    if (ranges[k].last != ranges[k + 1].first) continue;
    ranges[k].beyond_last = true;
    ranges[k + 1].before_first = true;
  }
  std::erase_if(ranges,
                [](const BrokenRange& range) { return range.before_first && range.beyond_last; });
}

/// The ranges of u (axis 0) or v (axis 1) in which operations on it alone break: along lines of
/// constant u or v. They are halved until their ends are neighbouring doubles, or all of them is 0
/// but for rounding. None if there are too many. A range takes the operations on one parameter, not
/// the whole formula.
std::vector<BrokenRange> broken_ranges(SurfaceEnclosure& enclosure, const ParameterBox& domain,
                                       int axis) {
  BoxSubdivision<BrokenRange> search(std::vector{BrokenRange{domain.low[axis], domain.high[axis]}});
  const double zero = kRounding * domain.high[axis] - kRounding * domain.low[axis];
  while (!std::ranges::all_of(search.open(), &BrokenRange::is_least)) {
    search.test([&](const BrokenRange& range) {
      const bool is_broken =
          range.is_least || enclosure.count_breaks_of_one(axis, range.first, range.last) > 0;
      return is_broken ? ProofOutcome::Open : ProofOutcome::Proved;
    });
    if (search.open().size() > kMostFollowed) keep_ends_of_runs(search.open());
    if (search.open().size() > kMostOpen) return {};
    search.halve_each([zero](const BrokenRange& range, std::vector<BrokenRange>& next) {
      const double middle = std::midpoint(range.first, range.last);
      const bool is_zero = std::max(std::fabs(range.first), std::fabs(range.last)) <= zero;
      if (is_zero || middle == range.first || middle == range.last) {
        next.push_back(range);
        next.back().is_least = true;
      } else {
        next.push_back({range.first, middle, range.before_first});
        next.push_back({middle, range.last, false, range.beyond_last});
      }
    });
  }
  keep_ends_of_runs(search.open());
  return search.open();
}

/// The number of lines that ranges are of: those that touch are of one.
std::size_t count_lines(std::span<const BrokenRange> ranges) {
  std::size_t lines = 0;
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    if (k == 0 || ranges[k - 1].last != ranges[k].first) ++lines;
  }
  return lines;
}

/// The boxes around the points where lines of constant u and of constant v cross along which
/// operations break: four at most for each. None if there are too many.
std::vector<ParameterBox> crossings_of_lines(SurfaceEnclosure& enclosure,
                                             const ParameterBox& domain) {
  std::vector<ParameterBox> boxes;
  const std::vector<BrokenRange> of_u = broken_ranges(enclosure, domain, 0);
  if (of_u.empty()) return boxes;
  const std::vector<BrokenRange> of_v = broken_ranges(enclosure, domain, 1);
  if (count_lines(of_u) * count_lines(of_v) > kMostFollowed) return boxes;
  for (const BrokenRange& u : of_u) {
    for (const BrokenRange& v : of_v) boxes.push_back({{u.first, v.first}, {u.last, v.last}});
  }
  return boxes;
}

/// The smallest boxes in which tangents are not proved to be continuous, but for those on curves,
/// and on lines of constant u or v alone: none if they are not as small as points.
std::vector<ParameterBox> nonsmooth_boxes(SurfaceEnclosure& enclosure, const Surface& surface) {
  std::size_t budget = kSearchesForPoints * ProofBudget(surface.bounds).boxes_of_search();
  BoxSubdivision<ParameterBox> search(std::vector{box_of(surface.domain)});
  const auto take = [&budget](std::size_t boxes) { budget = std::max(budget, boxes) - boxes; };
  while (!search.open().empty() && search.depth() < 2 * kAllHalvings) {
    const int to_points = std::max(2 * kHalvingsToSame - search.depth(), 0);
    const bool are_points = to_points == 0;
    // By then there are about as many boxes around points as there will be at each level.
    const bool is_settled = search.depth() >= 2 * kHalvingsToSight && !are_points;
    const std::size_t levels = is_settled ? static_cast<std::size_t>(to_points) : 1;
    if (budget < levels * search.open().size()) {
      if (are_points) break;
      return {};
    }
    take(search.open().size());
    search.test([&](const ParameterBox& box) {
      const std::span<const Interval> bounds = enclosure.enclose(box);
      if (are_continuous(bounds)) return ProofOutcome::Proved;
      const bool is_hole = least_defined(bounds.first(3)) == Defined::No;
      const bool is_closed = is_hole || enclosure.count_breaks_of_both(box) == 0;
      return is_closed ? ProofOutcome::Refuted : ProofOutcome::Open;
    });
    if (search.open().size() > (are_points ? kMostOpen : kMostFollowed)) {
      take(search.open().size());
      are_points ? keep_crossings(enclosure, search.open()) : keep_points(enclosure, search.open());
    }
    search.halve_in_turn(AtLastDigit::Keep);
  }
  return search.open();
}

/// Candidates for a coordinate of the point in a box, the best first.
std::vector<double> coordinates(double low, double high, double range) {
  if (std::min(std::fabs(low), std::fabs(high)) <= kRounding * range) return {0, low, high};
  return {low, high};
}

/// A place at which the surface may not be smooth, and how many of r, r_u and r_v it has there. A
/// point such as that of hypot(u^2 - 2, v) is no double: all those beside it have tangents.
struct Candidate {
  dvec2 uv;
  int defined;
};

/// Whether a place is at the edge of a domain. There a jump shows one of its sheets alone.
bool is_at_edge(const dvec2& uv, const ParameterBox& domain) {
  const dvec2 near = kNearly * domain.size();
  return glm::any(glm::lessThan(glm::abs(uv - domain.low), near)) ||
         glm::any(glm::lessThan(glm::abs(uv - domain.high), near));
}

/// One candidate for the boxes around a point, with the fewest defined: where two lines cross on
/// which one tangent is undefined, both are.
std::vector<Candidate> candidates_in(const Surface& surface, std::span<const ParameterBox> boxes,
                                     unsigned threads) {
  const dvec2 range = box_of(surface.domain).size();
  std::vector<dvec2> places;
  for (const auto& [low, high] : boxes) {
    for (const double u : coordinates(low.x, high.x, range.x)) {
      for (const double v : coordinates(low.y, high.y, range.y)) places.emplace_back(u, v);
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, places, threads);
  std::vector<Candidate> all;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const SurfacePoint& p = points[k];
    const int tangents = (is_finite(p.r_u) ? 1 : 0) + (is_finite(p.r_v) ? 1 : 0);
    all.push_back({places[k], is_finite(p.position) ? 1 + tangents : 0});
  }
  std::ranges::stable_sort(all, {}, &Candidate::defined);
  std::vector<Candidate> apart;
  for (const Candidate& candidate : all) {
    const auto is_there = [&](const Candidate& other) {
      return glm::length((candidate.uv - other.uv) / range) < kNearly;
    };
    if (std::ranges::none_of(apart, is_there)) apart.push_back(candidate);
  }
  return apart;
}

}  // namespace

NonsmoothPoints find_nonsmooth_points(const Surface& surface, double diagonal, unsigned threads) {
  SurfaceEnclosure enclosure(surface, Bounded::Tangents);
  std::vector<ParameterBox> boxes = nonsmooth_boxes(enclosure, surface);
  const auto crossings = crossings_of_lines(enclosure, box_of(surface.domain));
  boxes.insert(boxes.end(), crossings.begin(), crossings.end());
  const std::vector<Candidate> candidates = candidates_in(surface, boxes, threads);
  std::vector<dvec2> places(candidates.size());
  std::ranges::transform(candidates, places.begin(), &Candidate::uv);
  const std::vector<PointSingularity> singularities =
      classify_points(surface, places, diagonal, threads);
  NonsmoothPoints rough;
  for (std::size_t k = 0; k < candidates.size(); ++k) {
    const auto& [uv, defined] = candidates[k];
    using enum PointSingularity::Kind;
    const PointSingularity::Kind kind = singularities[k].kind;
    // A vertex with a position would have any of those around the point. A pole on a line of jumps,
    // as of sign(v) + 1/hypot(u, v), has no leaf to itself.
    if ((kind == Essential || kind == Pole) && defined == 0) rough.without_limit.push_back(uv);
    if (kind != Removable) continue;
    const bool lacks_tangents = defined == 1 || defined == 2;
    if (defined == 3 && is_at_edge(uv, box_of(surface.domain))) continue;
    if (lacks_tangents || normals_around(surface, uv).size() > 1) rough.conical.push_back(uv);
  }
  return rough;
}

}  // namespace saddle
