#include "mesh/features/discontinuities.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "mesh/features/approach.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/continuity.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Halvings of a line for a proof that it is continuous, before it is searched.
constexpr int kProofHalvings = 3;

/// Halvings that end most searches for creases; the others go on with heights.
constexpr int kPlainHalvings = 8;

/// Where normals can only jump to their opposites, unit normals nearer to each other have no cusp
/// between them, unless the surface turns back by 166 degrees.
constexpr double kNearOpposites = 0.25;

/// Bisects positions, which it evaluates at the ends first. `whole`: the lines that the lines are
/// parts of.
std::vector<LocatedDiscontinuity> follow_positions(const Surface& surface,
                                                   std::span<const Line> lines,
                                                   std::span<const Line> whole, double delta,
                                                   unsigned threads, std::size_t& work) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.insert(uv.end(), line.begin(), line.end());
  const std::vector<SurfacePoint> ends = evaluate(surface, uv, threads);
  std::vector<Bracket> gaps;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    gaps.push_back(bracket_of(lines[k], whole[k], ends[2 * k], ends[2 * k + 1]));
  }
  work += uv.size();
  return bisect_positions(surface, gaps, delta, Prefer::Largest, kAllHalvings, threads, work);
}

/// The parts of lines that bounds do not prove to be continuous, beside the discontinuities found
/// so far. A line with a pole has none: all of it is cut away.
std::vector<LinePart> unproved_parts(const Surface& surface, std::span<const Line> lines,
                                     std::span<const LocatedDiscontinuity> found, double delta,
                                     std::size_t& work) {
  std::vector<LinePart> parts;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].kind == Discontinuity::None) {
      parts.push_back({k, lines[k]});
    } else if (found[k].kind == Discontinuity::Jump) {
      parts.push_back({k, {lines[k][0], found[k].ends[0]}, 1});
      parts.push_back({k, {found[k].ends[1], lines[k][1]}, 0});
    }
  }
  return unproved(surface, std::move(parts), delta, work);
}

/// Whether values between the ends of a gap exceed the largest double. The ends are then moved to
/// the last finite values.
bool is_beyond_doubles(const Surface& surface, unsigned threads, Line& ends) {
  const dvec2 middle = near_middle(ends);
  const dvec3 value = evaluate(surface, std::array{middle}, 1)[0].position;
  if (is_finite(value) || glm::any(glm::isnan(value))) return false;
  const std::array<Line, 2> ways = {Line{ends[0], middle}, Line{ends[1], middle}};
  const std::vector<dvec2> last = last_defined(surface, ways, kAllHalvings, threads);
  ends = {last[0], last[1]};
  return true;
}

/// Whether the surface diverges on either side of the discontinuities found on lines.
std::vector<bool> diverge_beside(const Surface& surface, std::span<const Line> lines,
                                 std::span<const LocatedDiscontinuity> found, double delta,
                                 unsigned threads) {
  std::vector<std::size_t> numbers;
  std::vector<Line> ways;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].kind == Discontinuity::None) continue;
    numbers.push_back(k);
    for (std::size_t end = 0; end < 2; ++end) ways.push_back({found[k].ends[end], lines[k][end]});
  }
  const std::vector<bool> far = diverge(surface, ways, delta, threads);
  std::vector<bool> result(lines.size(), false);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    result[numbers[i]] = far[2 * i] || far[2 * i + 1];
  }
  return result;
}

/// Corrects kinds by diverge(): a pole is where the surface diverges. A gap also grows at a jump if
/// the ends of its line happen to be alike; beside a pole, rounding makes jumps.
void verify(const Surface& surface, std::span<const Line> lines, double delta, unsigned threads,
            std::span<LocatedDiscontinuity> found) {
  const std::vector<bool> far = diverge_beside(surface, lines, found, delta, threads);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (far[k]) found[k].kind = Discontinuity::Pole;
    if (far[k] || found[k].kind != Discontinuity::Pole) continue;
    Line& ends = found[k].ends;
    if (is_beyond_doubles(surface, threads, ends)) continue;
    const dvec2 middle = near_middle(ends);
    const auto length = [](const Line& line) { return glm::distance(line[0], line[1]); };
    const bool is_gap =
        (middle == ends[0] || middle == ends[1]) && length(ends) <= kSame * length(lines[k]);
    found[k].kind = is_gap ? Discontinuity::Jump : Discontinuity::None;
  }
}

/// The discontinuities in unproved parts of lines. Around a pole of even order both ends of a part
/// may be alike, so that diverge() decides.
std::vector<LocatedDiscontinuity> look_at(const Surface& surface, std::span<const Line> lines,
                                          std::span<const LinePart> unproved_parts, double delta,
                                          unsigned threads, std::size_t& work) {
  std::vector<Line> parts;
  std::vector<Line> whole;
  std::vector<Line> ways;
  for (const auto& [line, part, broken_end] : unproved_parts) {
    parts.push_back(part);
    whole.push_back(lines[line]);
    ways.push_back({part[0], lines[line][0]});
    ways.push_back({part[1], lines[line][1]});
  }
  std::vector<LocatedDiscontinuity> found =
      follow_positions(surface, parts, whole, delta, threads, work);
  const std::vector<bool> far = diverge(surface, ways, delta, threads);
  const std::vector<bool> beside = diverge_beside(surface, parts, found, delta, threads);
  work += kApproach.size() * ways.size();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_pole = far[2 * i] || far[2 * i + 1] || beside[i];
    if (found[i].kind == Discontinuity::None) found[i].ends = parts[i];
    // An undefined place is no pole unless the surface diverges: sin(1/u) does not.
    if (is_pole) found[i].kind = Discontinuity::Pole;
    if (!is_pole && found[i].kind == Discontinuity::Pole &&
        !is_beyond_doubles(surface, threads, found[i].ends)) {
      found[i].kind = Discontinuity::None;
    }
  }
  return found;
}

/// The parts of lines beside their jumps in which there are steps that slopes do not explain: other
/// jumps, nearer than bounds tell. Places are looked at 4 times as near each, and down to kSame.
std::vector<LinePart> steps_beside(const Surface& surface, std::span<const Line> lines,
                                   std::span<const LocatedDiscontinuity> found, double delta,
                                   unsigned threads, std::size_t& work) {
  constexpr double kNearer = 0.25;
  std::vector<double> shares = {1};  // of the way from the jump
  while (shares.back() > kSame) shares.push_back(kNearer * shares.back());
  shares.push_back(0);
  std::vector<std::size_t> numbers;
  std::vector<dvec2> uv;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].kind != Discontinuity::Jump) continue;
    for (std::size_t end = 0; end < 2; ++end) {
      numbers.push_back(k);
      for (const double share : shares)
        uv.push_back(glm::mix(found[k].ends[end], lines[k][end], share));
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  work += uv.size();
  std::vector<LinePart> parts;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const bool is_first = i % 2 == 0;
    const std::size_t first = i * shares.size();
    for (std::size_t j = first; j + 1 < first + shares.size(); ++j) {
      const dvec2 way = uv[j + 1] - uv[j];
      const auto slope = [&](const SurfacePoint& p) { return way.x * p.r_u + way.y * p.r_v; };
      const dvec3 step = points[j + 1].position - points[j].position;
      const double gap = glm::length(step - 0.5 * (slope(points[j]) + slope(points[j + 1])));
      if (!(gap > delta)) continue;
      const Line part = {uv[j], uv[j + 1]};
      parts.push_back({numbers[i], is_first ? part : Line{part[1], part[0]}});
    }
  }
  return parts;
}

/// The part of a line that holds two of its parts.
Line hull(const Line& a, const Line& b, const Line& line) {
  const auto before = [&](const dvec2& first, const dvec2& second) {
    return glm::distance(line[0], first) < glm::distance(line[0], second);
  };
  return {before(b[0], a[0]) ? b[0] : a[0], before(a[1], b[1]) ? b[1] : a[1]};
}

/// The middle between two parts of a line that have no place in common.
dvec2 middle_between(const Line& a, const Line& b, const Line& line) {
  const bool is_first = glm::distance(line[0], a[0]) < glm::distance(line[0], b[0]);
  return is_first ? 0.5 * (a[1] + b[0]) : 0.5 * (b[1] + a[0]);
}

/// Adds a discontinuity in an unproved part to the known one of its line.
void add(const LocatedDiscontinuity& more, const Line& line, LocatedDiscontinuity& known) {
  if (more.kind == Discontinuity::None) return;
  const double apart = glm::distance(known.ends[0], more.ends[0]);
  if (known.kind == Discontinuity::None) {
    known = more;
  } else if (apart > kSame * glm::distance(line[0], line[1])) {
    known.between = middle_between(known.ends, more.ends, line);
  } else if (more.kind == Discontinuity::Pole) {
    known.kind = Discontinuity::Pole;
  } else {
    known.ends = hull(known.ends, more.ends, line);
  }
}

/// Discontinuities of lines that are not proved to be continuous.
std::vector<LocatedDiscontinuity> find_discontinuities_in(const Surface& surface,
                                                          std::span<const Line> lines, double delta,
                                                          unsigned threads, std::size_t& work) {
  std::vector<LocatedDiscontinuity> found =
      follow_positions(surface, lines, lines, delta, threads, work);
  verify(surface, lines, delta, threads, found);
  std::vector<LinePart> open = unproved_parts(surface, lines, found, delta, work);
  const auto steps = steps_beside(surface, lines, found, delta, threads, work);
  open.insert(open.end(), steps.begin(), steps.end());
  const auto from_known = [&](const LinePart& part) {
    const LocatedDiscontinuity& known = found[part.line];
    return known.kind == Discontinuity::None ? 0 : glm::distance(part.part[0], known.ends[0]);
  };
  std::ranges::stable_sort(open, [&](const LinePart& a, const LinePart& b) {
    return a.line != b.line ? a.line < b.line : from_known(a) < from_known(b);
  });
  const std::vector<LocatedDiscontinuity> more =
      look_at(surface, lines, open, delta, threads, work);
  for (std::size_t i = 0; i < open.size(); ++i) {
    add(more[i], lines[open[i].line], found[open[i].line]);
  }
  return found;
}

}  // namespace

std::vector<LocatedDiscontinuity> find_discontinuities(const Surface& surface,
                                                       std::span<const Line> lines, double delta,
                                                       unsigned threads, std::size_t& work) {
  std::vector<LinePart> whole;
  for (std::size_t k = 0; k < lines.size(); ++k) whole.push_back({k, lines[k]});
  std::vector<std::size_t> open;
  std::vector<Line> open_lines;
  for (const LinePart& part : unproved(surface, std::move(whole), delta, work, kProofHalvings)) {
    if (!open.empty() && open.back() == part.line) continue;
    open.push_back(part.line);
    open_lines.push_back(lines[part.line]);
  }
  std::vector<LocatedDiscontinuity> result(lines.size());
  const std::vector<LocatedDiscontinuity> found =
      find_discontinuities_in(surface, open_lines, delta, threads, work);
  for (std::size_t i = 0; i < open.size(); ++i) result[open[i]] = found[i];
  return result;
}

std::vector<std::vector<Line>> find_all_jumps(const Surface& surface, std::span<const Line> lines,
                                              std::span<const LocatedDiscontinuity> found,
                                              double delta, unsigned threads, std::size_t& work) {
  std::vector<std::vector<Line>> jumps(lines.size());
  std::vector<std::size_t> numbers;  // of the lines of parts that were not searched
  std::vector<Line> parts;
  const auto split = [&](std::size_t k, const Line& part, const LocatedDiscontinuity& at) {
    if (at.kind != Discontinuity::Jump || jumps[k].size() == kMostLineParts) {
      jumps[k].assign(kMostLineParts + 1, at.ends);
      return;
    }
    jumps[k].push_back(at.ends);
    for (const Line& rest : {Line{part[0], at.ends[0]}, Line{at.ends[1], part[1]}}) {
      if (rest[0] == rest[1]) continue;
      numbers.push_back(k);
      parts.push_back(rest);
    }
  };
  for (std::size_t k = 0; k < lines.size(); ++k) split(k, lines[k], found[k]);
  while (!parts.empty()) {
    const auto of = std::exchange(numbers, {});
    const auto searched = std::exchange(parts, {});
    const auto more = find_discontinuities(surface, searched, delta, threads, work);
    for (std::size_t i = 0; i < searched.size(); ++i) {
      const bool is_given_up = jumps[of[i]].size() > kMostLineParts;
      if (more[i].kind != Discontinuity::None && !is_given_up) split(of[i], searched[i], more[i]);
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (jumps[k].size() > kMostLineParts) jumps[k].clear();
    std::ranges::sort(jumps[k], {},
                      [&](const Line& jump) { return glm::distance(lines[k][0], jump[0]); });
  }
  return jumps;
}

std::vector<LocatedDiscontinuity> find_creases(const Surface& surface, std::span<const Line> lines,
                                               std::span<const std::array<dvec3, 2>> normals,
                                               unsigned threads, std::size_t& work) {
  const double chord = 2 * std::sin(0.5 * kCreaseDegrees * std::numbers::pi / 180);
  const auto [open, only_cusps] = unproved_normals(surface, lines, work);
  std::vector<Bracket> gaps;
  gaps.reserve(open.size());
  for (const std::size_t k : open) gaps.push_back({lines[k], lines[k], normals[k]});
  const auto normal = [](const SurfacePoint& point) {
    return normal_direction(point).value_or(dvec3(kNan));
  };
  const auto height = [](const std::array<dvec3, 2>& at_ends, const SurfacePoint& point) {
    return glm::dot(glm::cross(point.r_u, point.r_v), at_ends[0] - at_ends[1]);
  };
  const BisectedVector turning = {.value = normal,
                                  .height = height,
                                  .delta = only_cusps ? kNearOpposites : chord,
                                  .beyond = chord,
                                  .are_positions = false,
                                  .plain = kPlainHalvings};
  const std::vector<LocatedDiscontinuity> found =
      bisect_discontinuities(surface, gaps, turning, threads, work);
  std::vector<LocatedDiscontinuity> result(lines.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    result[open[i]] = found[i];
    result[open[i]].is_cusp = only_cusps && found[i].kind != Discontinuity::None;
  }
  return result;
}

}  // namespace saddle
