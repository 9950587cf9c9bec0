#include "mesh/features/bisect_discontinuities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/bisect_together.h"
#include "mesh/features/removable.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// A gap between neighbouring doubles is no jump if it shrinks from the gap between places 2^21
/// units of rounding apart: abs(u)^0.05 and 1/ln(u) come to 0 ever more slowly.
constexpr std::size_t kFarOutward = 7;
/// The part of a line at which it is halved.
constexpr double kShare = 0.498;

/// A place without a value may be a cusp itself. It is then tried on both sides of that.
constexpr int kMostMisses = 2;

/// Places beyond the ends of a jump, in units of rounding. A rounded condition may be 0 for
/// millions of doubles: 5*sin(u) is 5 as far as sqrt(2^-53) from where it should be.
constexpr std::array kOutward = {1.0,    0x1p3,  0x1p6,  0x1p9,  0x1p12, 0x1p15,
                                 0x1p18, 0x1p21, 0x1p24, 0x1p27, 0x1p30};
/// On a line this near one of its ends, in its lengths, no sheet is seen.
constexpr double kOnEnd = 1.0 / 16;
/// Values of their own make positions move at up to 4 of these places; sin(1/u) moves at most.
constexpr std::size_t kMostMoves = 4;
/// These units, in lengths of the line, at most: the places stay within 2^-14 of it.
constexpr double kMostUnit = 0x1p-44;

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

/// The distance of two values, also where its square would overflow.
double gap_between(const dvec3& a, const dvec3& b) {
  return safe_length(a - b);
}

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

/// The unit of rounding at a jump, along its line: the distance of the doubles beside it, or that
/// of doubles as large as the larger parameter, with which a condition may add the smaller, or as
/// the ranges, on which it may rise and fall.
dvec2 unit_of_rounding(const Search& search, const Line& line, const dvec2& ranges) {
  const dvec2 width = search.ends[1] - search.ends[0];
  const dvec2 whole = line[1] - line[0];
  const dvec2 at =
      glm::max(glm::max(glm::abs(search.ends[0]), glm::abs(search.ends[1])), ranges);
  const double digits = std::numeric_limits<double>::epsilon() * std::max(at.x, at.y);
  const double share = std::min(digits / glm::length(whole), kMostUnit);
  return glm::length(width) > share * glm::length(whole) ? width : share * whole;
}

/// A place on a line, or the end of the line that it is beyond.
dvec2 within(const Line& line, std::size_t end, const dvec2& place) {
  const bool is_beyond = glm::dot(place - line[end], line[end] - line[1 - end]) > 0;
  return is_beyond ? line[end] : place;
}

/// One end of a jump, looked at outward.
struct OutwardEnd {
  dvec2 uv;     ///< where it moves
  dvec3 value;  ///< there
  dvec3 far;    ///< the value at the place kFarOutward
  std::size_t moves = 0;
};

/// `uv` and `points` of the end's places, kOutward.size() of them, have those of the jump's other
/// end between them. Steps longer than `far` are compared with the slope.
OutwardEnd moved_outward(const Search& jump, std::size_t end, double far, std::span<const dvec2> uv,
                         std::span<const SurfacePoint> points, const BisectedVector& bisected) {
  OutwardEnd moved{jump.ends[end], jump.at_ends[end],
                   bisected.value(points[2 * kFarOutward + end])};
  OutwardEnd before_run = moved;  // of moves that grow outward, as those of a root
  dvec3 before = jump.at_ends[end];
  double last_move = 0;
  for (std::size_t step = 0; step < kOutward.size(); ++step) {
    const std::size_t next = 2 * step + end;
    const dvec3 outward = bisected.value(points[next]);
    const dvec2 way = uv[next] - (step == 0 ? jump.ends[end] : uv[next - 2]);
    // Where the range is far from 0 the last places are far apart, and the surface is elsewhere.
    const bool is_far = bisected.are_positions && glm::length(way) > far;
    const dvec3 along = way.x * points[next].r_u + way.y * points[next].r_v;
    const dvec3 from = is_far && is_finite(along) ? before + along : before;
    const double move = gap_between(outward, from);
    before = outward;
    if (!is_finite(outward) || !(move >= bisected.beyond)) continue;
    if (last_move > kShrinks * move) before_run = moved;
    moved.uv = uv[next];
    moved.value = outward;
    ++moved.moves;
    last_move = move;
    const bool is_steep = step + 1 == kOutward.size();
    if (!is_steep) continue;
    moved = before_run;
    if (moved.moves <= kMostMoves) continue;
    moved.uv = jump.ends[end];
    moved.value = jump.at_ends[end];
  }
  return moved;
}

/// The range along a line.
double range_along(const Surface& surface, const Line& line) {
  const dvec2 way = line[1] - line[0];
  return glm::length(box_of(surface.domain).size() * way) / glm::length(way);
}

/// Whether lines end at values of their own, as floor(cos(u)) at u=0: their jumps are so near the
/// ends that rounding made the sheets between, and no two neighbouring directions of eight around an
/// end have its value. Elsewhere a sheet begins there, as at the tip of a disc.
std::vector<std::array<bool, 2>> end_on_single_values(const Surface& surface,
                                                      std::span<const Bracket> gaps,
                                                      std::span<const Search> searches,
                                                      const BisectedVector& bisected) {
  std::vector<std::array<bool, 2>> result(gaps.size(), {false, false});
  if (!bisected.are_positions) return result;
  struct End {
    std::size_t line, end;
  };
  std::vector<End> ends;
  std::vector<dvec2> around;
  const ParameterBox domain = box_of(surface.domain);
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    if (searches[k].found.kind != Discontinuity::Jump) continue;
    const Line& line = gaps[k].whole;
    const double near = std::min(kSliver * range_along(surface, line),
                                 kOnEnd * glm::distance(line[0], line[1]));
    for (const std::size_t end : {0U, 1U}) {
      const double distance = glm::distance(searches[k].ends[end], line[end]);
      if (distance == 0 || distance > near) continue;
      ends.push_back({k, end});
      for (const dvec2& way : kEightWays)
        around.push_back(line[end] + kStays * kSliver * domain.size() * way);
      around.push_back(line[end]);
    }
  }
  if (ends.empty()) return result;
  const std::vector<dvec3> found = evaluate_positions(surface, around, 1);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::size_t first = (kEightWays.size() + 1) * i;
    const auto is_same = [&](std::size_t way) {
      const std::size_t place = first + way % kEightWays.size();
      return nearest_in(domain, around[place]) == around[place] &&
             gap_between(found[place], found[first + kEightWays.size()]) < bisected.delta;
    };
    bool is_sheet = false;
    for (std::size_t way = 0; way < kEightWays.size(); ++way)
      is_sheet = is_sheet || (is_same(way) && is_same(way + 1));
    result[ends[i].line][ends[i].end] = !is_sheet;
  }
  return result;
}

/// Moves ends of jumps outward. At a jump a formula may have a value of its own, as sign(0) is 0,
/// for some doubles: it belongs to neither side. An end moves to the last place outward whose value
/// is far from the one before, within its line. If that is the outermost place, the surface is
/// steep, and the last moves, each larger than the one before, do not count. Where the end moves all
/// the way it may go to infinity.
void look_outward(const Surface& surface, std::span<const Bracket> gaps, std::span<Search> searches,
                  const BisectedVector& bisected, unsigned threads) {
  std::vector<std::size_t> jumps;
  std::vector<dvec2> uv;
  const dvec2 range = box_of(surface.domain).size();
  for (std::size_t k = 0; k < searches.size(); ++k) {
    const Search& search = searches[k];
    if (search.found.kind != Discontinuity::Jump) continue;
    jumps.push_back(k);
    const Line& line = gaps[k].whole;
    const dvec2 unit = unit_of_rounding(search, line, range);
    for (const double steps : kOutward) {
      uv.push_back(within(line, 0, search.ends[0] - steps * unit));
      uv.push_back(within(line, 1, search.ends[1] + steps * unit));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  const auto are_single = end_on_single_values(surface, gaps, searches, bisected);
  const double most = kMostUnit * kOutward.back();
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    Search& jump = searches[jumps[k]];
    const std::size_t first = 2 * k * kOutward.size();
    const Line& line = gaps[jumps[k]].whole;
    const double far = most * range_along(surface, line);
    const auto moved = [&](std::size_t end) {
      if (are_single[jumps[k]][end])
        return OutwardEnd{line[end], jump.at_ends[end], jump.at_ends[end]};
      return moved_outward(jump, end, far, std::span(uv).subspan(first),
                           std::span(points).subspan(first), bisected);
    };
    const std::array ends = {moved(0), moved(1)};
    jump.found.ends = {ends[0].uv, ends[1].uv};
    // Normals may turn slowly into a crease.
    const bool shrinks = gap_between(ends[0].value, ends[1].value) <
                         kShrinks * gap_between(ends[0].far, ends[1].far);
    if (!bisected.are_positions) continue;
    const bool is_pole = ends[0].moves + ends[1].moves > kMostMoves;
    if (is_pole) jump.found.kind = Discontinuity::Pole;
    const auto is_noise = [&](std::size_t end) {
      const std::size_t far = first + 2 * kFarOutward + end;
      return moved_by_last_digit(points[far], uv[far]) > bisected.delta;
    };
    const bool is_closed =
        jump.is_between && !is_pole &&
        (gap_between(ends[0].value, ends[1].value) < bisected.delta || is_noise(0) || is_noise(1));
    if (shrinks || is_closed) jump.found.kind = Discontinuity::None;
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
  if (bisected.halvings >= kAllHalvings) look_outward(surface, gaps, searches, bisected, threads);
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
