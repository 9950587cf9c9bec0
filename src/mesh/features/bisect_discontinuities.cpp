#include "mesh/features/bisect_discontinuities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/bisect_together.h"
#include "mesh/features/look_outward.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// The part of a line at which it is halved.
constexpr double kShare = 0.498;

/// A place without a value may be a cusp itself. It is then tried on both sides of that.
constexpr int kMostMisses = 2;

/// A line that is being bisected.
struct Search {
  Line ends;
  std::array<dvec3, 2> at_ends;
  std::array<dvec3, 2> slopes;  ///< at the ends, by the share of the first line
  double first_gap = 0;
  bool done = false;
  LocatedDiscontinuity found = {};
  /// BisectedVector::height at the ends; NaN where it is not known.
  std::array<double, 2> heights = {kNan, kNan};
  double length = 1;           ///< of the rest, in lengths of the first line
  double share = kShare;       ///< part of the line at which it is evaluated
  double width = 1;            ///< length of the line, in lengths when heights were first known
  int steps = 0;               ///< since heights were first known
  int misses = 0;              ///< evaluations that gave no value
  bool is_missed = false;      ///< the last one gave none
  bool is_between = false;     ///< between the ends there is no value, or one of its own
  bool has_passed_by = false;  ///< LocatedDiscontinuity::has_passed_by
};

Search begin(const Bracket& gap) {
  Search search{gap.line, gap.at_ends, gap.slopes};
  search.first_gap = gap_between(gap.at_ends[0], gap.at_ends[1]);
  search.done = !is_finite(gap.at_ends[0]) || !is_finite(gap.at_ends[1]);
  return search;
}

void finish(Search& search, Discontinuity kind) {
  search.done = true;
  search.found = {.kind = kind, .ends = search.ends, .has_passed_by = search.has_passed_by};
}

/// The kind of a gap that no halving has closed.
Discontinuity at_last_digits(const Search& search, double delta) {
  const double gap = gap_between(search.at_ends[0], search.at_ends[1]);
  // A gap that has shrunk to kSame of its first size is a steep slope, not a jump.
  if (gap < std::max(delta, kSame * search.first_gap)) return Discontinuity::None;
  return Discontinuity::Jump;
}

/// The part of a line at which it is evaluated next: near the zero of the chord of the heights at
/// its ends.
double next_share(const Search& search) {
  const auto& [first, last] = search.heights;
  if (!(first * last < 0) || !std::isfinite(first - last)) return kShare;
  const double least = least_share(search.ends);
  if (!(least < kShare)) return kShare;
  if (search.is_missed) {
    const double beside = search.share + (search.misses % 2 == 0 ? least : -least);
    return std::clamp(beside, least, 1 - least);
  }
  const double share = share_of_zero(first, last, search.width, std::exp2(1 - search.steps));
  return std::clamp(share, least, 1 - least);
}

/// The values at the place at which a line is evaluated.
struct Look {
  dvec2 uv;
  dvec3 value;
  double height;
  std::optional<dvec3> slope;  ///< by the share of the first line; nothing of normals
};

/// The part of a gap that the slope at neither of its ends explains: its jumps. No jump exceeds the
/// gap and the way along the lesser slope: toward an upright end the other one is far more than the
/// surface moves. Between two upright ends it is the gap.
double unexplained_gap(const dvec3& gap, double length, const dvec3& slope_from,
                       const dvec3& slope_to, double share) {
  double largest = 0;
  double lesser = kInfinity;
  for (const dvec3& slope : {share * slope_from, share * slope_to}) {
    if (!is_finite(slope)) continue;
    largest = std::max(largest, safe_length(gap - slope));
    lesser = std::min(lesser, safe_length(slope));
  }
  return lesser == kInfinity ? length : std::min(largest, length + lesser);
}

/// Whether the larger gap is in the first part of a line: by what slopes do not explain, where they
/// do not explain all. Beside a pole both gaps may be the same to rounding; then it is the part
/// into which the surface moves away from the ends. Notes a larger gap that is passed by.
bool is_in_first_part(Search& search, const Look& look, double first_gap, double last_gap,
                      const BisectedVector& bisected) {
  // Only gaps that are nearly the same can have their sum so short.
  const double short_gap = kOfSecondOrder * std::min(first_gap, last_gap);
  if (look.slope && std::fabs(first_gap - last_gap) <= short_gap &&
      gap_between(search.at_ends[0], search.at_ends[1]) < short_gap) {
    const double away = glm::dot(*look.slope / safe_length(*look.slope),
                                 (look.value - search.at_ends[0]) / first_gap);
    if (away != 0 && std::isfinite(away)) return away < 0;
  }
  if (look.slope) {
    const double first =
        unexplained_gap(look.value - search.at_ends[0], first_gap, search.slopes[0], *look.slope,
                        search.length * search.share);
    const double last = unexplained_gap(search.at_ends[1] - look.value, last_gap, *look.slope,
                                        search.slopes[1], search.length * (1 - search.share));
    if (std::max(first, last) > bisected.delta) {
      const bool is_first = first > bisected.first_gap;
      search.has_passed_by = search.has_passed_by || (is_first && first < last);
      return is_first || first >= last;
    }
  }
  return first_gap >= last_gap;
}

/// Whether a place is on a jump and has a value between those beside it, as sign(0) is: what is
/// left of the line is short, and slopes do not explain its gap, though both parts are small.
bool is_value_of_its_own(const Search& search, const Look& look, double first_gap, double last_gap,
                         double delta) {
  if (!look.slope || search.length > kNearly) return false;
  if (gap_between(search.at_ends[0], search.at_ends[1]) < delta) return false;
  const double first = unexplained_gap(look.value - search.at_ends[0], first_gap, search.slopes[0],
                                       *look.slope, search.length * search.share);
  const double last = unexplained_gap(search.at_ends[1] - look.value, last_gap, *look.slope,
                                      search.slopes[1], search.length * (1 - search.share));
  return first + last >= delta;
}

/// Goes on with one of the parts.
void advance(Search& search, const Look& look, const BisectedVector& bisected) {
  const double delta = bisected.delta;
  if (look.uv == search.ends[0] || look.uv == search.ends[1]) {
    return finish(search, at_last_digits(search, delta));
  }
  if (!is_finite(look.value)) {
    if (search.misses == kMostMisses) {
      // Between two sheets, as on (u-v)/abs(u-v), or at a pole: look_outward() tells.
      search.is_between = bisected.are_positions && search.length < kSame;
      return finish(search, search.is_between ? Discontinuity::Jump : Discontinuity::Pole);
    }
    ++search.misses;
    search.is_missed = true;
    return;
  }
  search.is_missed = false;
  const double first = gap_between(search.at_ends[0], look.value);
  const double second = gap_between(look.value, search.at_ends[1]);
  if (std::max(first, second) < delta) {
    // look_outward() tells it from rounding.
    search.is_between = bisected.halvings >= kAllHalvings &&
                        is_value_of_its_own(search, look, first, second, delta);
    return finish(search, search.is_between ? Discontinuity::Jump : Discontinuity::None);
  }
  const std::size_t replaced = is_in_first_part(search, look, first, second, bisected) ? 1 : 0;
  search.ends[replaced] = look.uv;
  search.at_ends[replaced] = look.value;
  search.heights[replaced] = look.height;
  if (look.slope) search.slopes[replaced] = *look.slope;
  search.length *= replaced == 1 ? search.share : 1 - search.share;
  search.width *= replaced == 1 ? search.share : 1 - search.share;
  ++search.steps;
}

/// Corrects the kinds and ends of jumps by what is outward of them.
void correct_jumps(const Surface& surface, std::span<const Bracket> gaps,
                   std::span<Search> searches, const BisectedVector& bisected, unsigned threads) {
  std::vector<std::size_t> numbers;
  std::vector<LeftGap> left;
  for (std::size_t k = 0; k < searches.size(); ++k) {
    const Search& search = searches[k];
    if (search.found.kind != Discontinuity::Jump) continue;
    numbers.push_back(k);
    left.push_back({gaps[k].whole, search.ends, search.at_ends, search.is_between});
  }
  const std::vector<OutwardLook> looks = look_outward(surface, left, bisected, threads);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    searches[numbers[i]].found.kind = looks[i].kind;
    searches[numbers[i]].found.ends = looks[i].ends;
  }
}

/// Evaluates the heights at the ends of lines.
void evaluate_heights(const Surface& surface, std::span<Search> searches,
                      std::span<const std::size_t> which, const BisectedVector& bisected,
                      unsigned threads) {
  std::vector<dvec2> uv;
  for (const std::size_t k : which) {
    uv.insert(uv.end(), searches[k].ends.begin(), searches[k].ends.end());
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  for (std::size_t i = 0; i < which.size(); ++i) {
    Search& search = searches[which[i]];
    search.heights = {bisected.height(search.at_ends, points[2 * i]),
                      bisected.height(search.at_ends, points[2 * i + 1])};
    search.width = 1;
    search.steps = 0;
  }
}

}  // namespace

Bracket bracket_of(const Line& line, const Line& whole, const SurfacePoint& first,
                   const SurfacePoint& last) {
  const dvec2 way = line[1] - line[0];
  return {line,
          whole,
          {first.position, last.position},
          {way.x * first.r_u + way.y * first.r_v, way.x * last.r_u + way.y * last.r_v}};
}

dvec2 near_middle(const Line& line) {
  return line[0] + kShare * (line[1] - line[0]);
}

std::vector<LocatedDiscontinuity> bisect_discontinuities(const Surface& surface,
                                                         std::span<const Bracket> gaps,
                                                         const BisectedVector& bisected,
                                                         unsigned threads, std::size_t& work) {
  std::vector<Search> searches;
  searches.reserve(gaps.size());
  std::ranges::transform(gaps, std::back_inserter(searches), begin);
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < searches.size(); ++k) {
    if (!searches[k].done) open.push_back(k);
  }
  const auto place = [&work](Search& search) {
    ++work;
    search.share = next_share(search);
    return search.ends[0] + search.share * (search.ends[1] - search.ends[0]);
  };
  const auto is_done = [&](Search& search, const dvec2& uv, const SurfacePoint& point) {
    const dvec2 way = gaps[static_cast<std::size_t>(&search - searches.data())].line[1] -
                      gaps[static_cast<std::size_t>(&search - searches.data())].line[0];
    Look look{uv, bisected.value(point), kNan, std::nullopt};
    if (bisected.height) look.height = bisected.height(search.at_ends, point);
    if (bisected.are_positions) look.slope = way.x * point.r_u + way.y * point.r_v;
    advance(search, look, bisected);
    return search.done;
  };
  const int plain = bisected.height ? bisected.plain : bisected.halvings;
  bisect_together(surface, searches, open, {plain, threads}, place, is_done);
  if (bisected.height) {
    evaluate_heights(surface, searches, open, bisected, threads);
    bisect_together(surface, searches, open, {kAllHalvings - plain, threads}, place, is_done);
  }
  for (const std::size_t k : open) finish(searches[k], at_last_digits(searches[k], bisected.delta));
  if (bisected.halvings >= kAllHalvings) correct_jumps(surface, gaps, searches, bisected, threads);
  std::vector<LocatedDiscontinuity> result(searches.size());
  std::ranges::transform(searches, result.begin(), &Search::found);
  return result;
}

std::vector<LocatedDiscontinuity> bisect_positions(const Surface& surface,
                                                   std::span<const Bracket> gaps,
                                                   const BisectedPositions& bisected,
                                                   unsigned threads, std::size_t& work) {
  /// A smooth part of a leaf leaves less than 4 tolerances unexplained by its slopes: its sagitta
  /// is a quarter of that.
  constexpr double kSmooth = 4;
  const BisectedVector positions = {
      .value = [](const SurfacePoint& point) { return point.position; },
      .height = {},
      .delta = bisected.delta,
      .beyond = bisected.delta,
      .are_positions = true,
      .plain = 0,
      .halvings = bisected.halvings,
      .first_gap = bisected.prefer == Prefer::First ? kSmooth * bisected.delta : kInfinity};
  return bisect_discontinuities(surface, gaps, positions, threads, work);
}

}  // namespace saddle
