#include "mesh/features/look_outward.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/numbers.h"
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
/// Places beyond the ends of a jump, in units of rounding. A rounded condition may be 0 for
/// millions of doubles: 5*sin(u) is 5 as far as sqrt(2^-53) from where it should be.
constexpr std::array kOutward = {1.0,    0x1p3,  0x1p6,  0x1p9,  0x1p12, 0x1p15,
                                 0x1p18, 0x1p21, 0x1p24, 0x1p27, 0x1p30};
/// Values of their own make positions move at up to 4 of these places; sin(1/u) moves at most.
constexpr std::size_t kMostMoves = 4;
/// These units, in lengths of the line, at most: the places stay within 2^-14 of it.
constexpr double kMostUnit = 0x1p-44;

/// The unit of rounding at a jump, along its line: the distance of the doubles beside it, or that
/// of doubles as large as the larger parameter, with which a condition may add the smaller, or as
/// the ranges, on which it may rise and fall.
dvec2 unit_of_rounding(const LeftGap& gap, const dvec2& ranges) {
  const dvec2 width = gap.ends[1] - gap.ends[0];
  const dvec2 whole = gap.line[1] - gap.line[0];
  const dvec2 at = glm::max(glm::max(glm::abs(gap.ends[0]), glm::abs(gap.ends[1])), ranges);
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
OutwardEnd moved_outward(const LeftGap& jump, std::size_t end, double far,
                         std::span<const dvec2> uv, std::span<const SurfacePoint> points,
                         const BisectedVector& bisected) {
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

/// Where a line ends beside a pole. A pole may have a value of its own, as that of
/// (u==v)?0:1/(u-v): past it the surface leaps to farther positions.
dvec2 end_beside_pole(const LeftGap& pole, std::size_t end, std::span<const dvec2> uv,
                      std::span<const SurfacePoint> points, double delta) {
  const dvec3& at_end = pole.at_ends[end];
  for (std::size_t next = end; next < 2 * kOutward.size(); next += 2) {
    const dvec3& position = points[next].position;
    if (gap_between(position, at_end) < delta) continue;
    const double length = safe_length(position);
    const bool leaps = std::isfinite(length) && length > kStays * safe_length(at_end);
    return leaps ? uv[next] : pole.ends[end];
  }
  return pole.ends[end];
}

/// The range along a line.
double range_along(const Surface& surface, const Line& line) {
  const dvec2 way = line[1] - line[0];
  return glm::length(box_of(surface.domain).size() * way) / glm::length(way);
}

/// Whether lines end at values of their own, as floor(cos(u)) at u=0: their jumps are so near the
/// ends that rounding made the sheets between, and no two neighbouring directions of eight around
/// an end have its value. Elsewhere a sheet begins there, as at the tip of a disc.
std::vector<std::array<bool, 2>> end_on_single_values(const Surface& surface,
                                                      std::span<const LeftGap> gaps,
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
    const Line& line = gaps[k].line;
    const double near =
        std::min(kSliver * range_along(surface, line), kClose * glm::distance(line[0], line[1]));
    for (const std::size_t end : {0U, 1U}) {
      const double distance = glm::distance(gaps[k].ends[end], line[end]);
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

/// Judges a gap by the looks outward of it. `uv`, `points`: of these. `is_single`: the line's ends
/// have values of their own.
OutwardLook judge(const LeftGap& gap, double far, std::span<const dvec2> uv,
                  std::span<const SurfacePoint> points, const std::array<bool, 2>& is_single,
                  const BisectedVector& bisected) {
  const auto moved = [&](std::size_t end) {
    if (is_single[end]) return OutwardEnd{gap.line[end], gap.at_ends[end], gap.at_ends[end]};
    return moved_outward(gap, end, far, uv, points, bisected);
  };
  const std::array ends = {moved(0), moved(1)};
  OutwardLook look{Discontinuity::Jump, {ends[0].uv, ends[1].uv}};
  // Normals may turn slowly into a crease.
  if (!bisected.are_positions) return look;
  const bool is_pole = ends[0].moves + ends[1].moves > kMostMoves;
  if (is_pole) {
    look.kind = Discontinuity::Pole;
    for (const std::size_t end : {0U, 1U}) {
      const dvec2 beside = end_beside_pole(gap, end, uv, points, bisected.delta);
      if (beside != gap.ends[end]) look.ends[end] = beside;
    }
  }
  const bool shrinks =
      gap_between(ends[0].value, ends[1].value) < kShrinks * gap_between(ends[0].far, ends[1].far);
  const auto is_noise = [&](std::size_t end) {
    const std::size_t place = 2 * kFarOutward + end;
    return moved_by_last_digit(points[place], uv[place]) > bisected.delta;
  };
  const bool is_closed =
      gap.is_between && !is_pole &&
      (gap_between(ends[0].value, ends[1].value) < bisected.delta || is_noise(0) || is_noise(1));
  if (shrinks || is_closed) look.kind = Discontinuity::None;
  return look;
}

}  // namespace

std::vector<OutwardLook> look_outward(const Surface& surface, std::span<const LeftGap> gaps,
                                      const BisectedVector& bisected, unsigned threads) {
  std::vector<dvec2> uv;
  const dvec2 range = box_of(surface.domain).size();
  for (const LeftGap& gap : gaps) {
    const dvec2 unit = unit_of_rounding(gap, range);
    for (const double steps : kOutward) {
      uv.push_back(within(gap.line, 0, gap.ends[0] - steps * unit));
      uv.push_back(within(gap.line, 1, gap.ends[1] + steps * unit));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  const auto are_single = end_on_single_values(surface, gaps, bisected);
  const double most = kMostUnit * kOutward.back();
  std::vector<OutwardLook> looks;
  looks.reserve(gaps.size());
  const std::size_t each = 2 * kOutward.size();
  for (std::size_t k = 0; k < gaps.size(); ++k) {
    looks.push_back(judge(gaps[k], most * range_along(surface, gaps[k].line),
                          std::span(uv).subspan(k * each, each),
                          std::span(points).subspan(k * each, each), are_single[k], bisected));
  }
  return looks;
}

}  // namespace saddle
