#include "mesh/breaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include <glm/common.hpp>

#include "eval/enclose.h"
#include "mesh/continuity.h"
#include "mesh/corners.h"
#include "surface/normal.h"

namespace saddle {

namespace {

/// Halvings at most: doubles between two parameters run out before, except next to 0, where what
/// is left of the line is then 1e-30 of it.
constexpr int kMaxHalvings = 100;
/// A pole's gap is so many times as large at the end as at the beginning.
constexpr double kPoleGrowth = 50;
/// A gap that has shrunk to this part with its line is no jump, however steep the surface is.
constexpr double kVanishing = 1e-9;
/// A gap that is still shrinking after so many halvings, to less than this part until the last
/// digits, is none: 1/ln(u) comes to 0 ever more slowly, and those end before it does.
constexpr int kEarly = 24;
constexpr double kShrinks = 0.8;
/// Positions at the ends of a line are as nothing beside one between them if they differ by less
/// than this part of what that differs from them.
constexpr double kAlike = 1.0 / 4096;
/// Where lines are halved: a little off their middles, which are the places where a formula for
/// half of a range has its cusps, and no normal.
constexpr double kShare = 0.498;

/// Halvings of a line for a proof that it has no break: what they do not prove may have one, and is
/// searched.
constexpr int kProofHalvings = 3;

/// Halvings after which most lines are done, so that the others are worth more than halvings.
constexpr int kPlainHalvings = 8;
/// The same where there are only cusps: the first one tells most lines.
constexpr int kPlainHalvingsOfCusps = 1;
/// Places nearer to an end than so many doubles may be that end.
constexpr double kLeastStep = 2;
/// A good guess is the very place of a cusp, which has no normal: then it is looked at beside it,
/// on this side and on the other.
constexpr int kMostMisses = 2;

/// Where a surface is looked at on its way to a place, in ways.
constexpr std::array kApproach = {0x1p-12, 0x1p-16, 0x1p-20, 0x1p-24, 0x1p-28, 0x1p-32};
/// From one of those to the next it moves by less than this part of what it did before, or goes to
/// infinity: a root of order 12 moves by 0.79 of it, ln by all of it.
constexpr double kArrives = 0.8;
/// What moves on by the same again and again, as ln does, makes so many of those steps until
/// doubles run out beside 0.
constexpr double kStepsLeft = 256;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// Breaks that are this near to each other, beside their line, are one: where a formula has a value
/// of its own there are two steps.
constexpr double kSamePlace = 1e-9;

/// Places beyond the ends of a jump, in its widths: adjacent doubles.
constexpr std::array kOutward = {1.0, 2.0, 4.0, 8.0};

/// A line on its way.
struct Search {
  Line ends;
  std::array<dvec3, 2> at_ends;
  double first_gap = 0;
  double early_gap = 0;  ///< after kEarly halvings, of positions
  bool done = false;
  Found found = {};
  /// What changes its sign where the line is broken, at its ends; NaN where nobody knows.
  std::array<double, 2> heights = {kUnknown, kUnknown};
  double share = kShare;   ///< of the line, where it is looked at
  double width = 1;        ///< of the line, beside when heights were first known
  int steps = 0;           ///< since then
  int misses = 0;          ///< times that there was no value where it was looked at
  bool is_missed = false;  ///< the last time
};

dvec2 between(const Line& ends) {
  return ends[0] + kShare * (ends[1] - ends[0]);
}

/// How far apart two values are, also where squares of that would overflow.
double gap_between(const dvec3& a, const dvec3& b) {
  return safe_length(a - b);
}

Search begin(const Line& line, const std::array<dvec3, 2>& at_ends) {
  Search search{line, at_ends};
  search.first_gap = gap_between(at_ends[0], at_ends[1]);
  search.done = !is_finite(at_ends[0]) || !is_finite(at_ends[1]);
  return search;
}

void finish(Search& search, Break kind) {
  search.done = true;
  search.found = {kind, search.ends};
}

/// What a gap is that no halving has closed.
Break at_last_digits(const Search& search, double delta) {
  const double gap = gap_between(search.at_ends[0], search.at_ends[1]);
  if (gap < kShrinks * search.early_gap) return Break::None;
  if (gap < std::max(delta, kVanishing * search.first_gap)) return Break::None;
  return gap > kPoleGrowth * search.first_gap ? Break::Pole : Break::Jump;
}

/// The part of a line from its first end to where it is looked at next: where the chord of the
/// heights at its ends is 0, a little nearer to the middle so that both ends come close, and never
/// so far from it that halvings would have been faster. Source: I. F. D. Oliveira, R. H. C.
/// Takahashi, "An enhancement of the bisection method average performance preserving minmax
/// optimality", 2020, with their n_0 = 1, kappa_1 = 0.2 and kappa_2 = 2.
double next_share(const Search& search) {
  constexpr double kAside = 0.2;
  const auto& [first, last] = search.heights;
  if (!(first * last < 0) || !std::isfinite(first - last)) return kShare;
  const auto& [a, b] = search.ends;
  const dvec2 way = glm::abs(b - a);
  const dvec2 place = glm::max(glm::abs(a), glm::abs(b));
  const double digits = kLeastStep * std::numeric_limits<double>::epsilon();
  const double least = digits * std::max(place.x, place.y) / std::max(way.x, way.y);
  if (!(least < kShare)) return kShare;
  if (search.is_missed) {
    const double beside = search.share + (search.misses % 2 == 0 ? least : -least);
    return std::clamp(beside, least, 1 - least);
  }
  const double on_chord = first / (first - last);
  const double side = on_chord < 0.5 ? 1 : -1;
  const double off = std::fabs(0.5 - on_chord);
  const double inward = std::max(off - kAside * search.width, 0.0);
  const double farthest = std::max(std::exp2(1 - search.steps) / search.width - 0.5, 0.0);
  return std::clamp(0.5 - side * std::min(inward, farthest), least, 1 - least);
}

/// What is known of the place at which a line is looked at.
struct Look {
  dvec2 uv;
  dvec3 value;
  double height;
  std::optional<dvec3> slope;  ///< along the line; nothing of normals
};

/// Whether to go on with the part of a line that ends where it is looked at: the one with the
/// larger gap. Beside a pole both gaps may be the same to rounding, the ends being as nothing
/// beside what is between them: then with the part into which the surface goes on moving away.
bool is_in_first_part(const Search& search, const Look& look, double first_gap, double last_gap) {
  const double ends = gap_between(search.at_ends[0], search.at_ends[1]);
  if (look.slope && ends < kAlike * std::min(first_gap, last_gap)) {
    const double away = glm::dot(*look.slope / safe_length(*look.slope),
                                 (look.value - search.at_ends[0]) / first_gap);
    if (away != 0 && std::isfinite(away)) return away < 0;
  }
  return first_gap >= last_gap;
}

/// Goes on with one of the parts.
void advance(Search& search, const Look& look, double delta) {
  if (look.uv == search.ends[0] || look.uv == search.ends[1]) {
    return finish(search, at_last_digits(search, delta));
  }
  if (!is_finite(look.value)) {
    if (search.misses == kMostMisses) return finish(search, Break::Pole);
    ++search.misses;
    search.is_missed = true;
    return;
  }
  search.is_missed = false;
  const double first = gap_between(search.at_ends[0], look.value);
  const double second = gap_between(look.value, search.at_ends[1]);
  if (std::max(first, second) < delta) return finish(search, Break::None);
  const std::size_t replaced = is_in_first_part(search, look, first, second) ? 1 : 0;
  search.ends[replaced] = look.uv;
  search.at_ends[replaced] = look.value;
  search.heights[replaced] = look.height;
  search.width *= replaced == 1 ? search.share : 1 - search.share;
  ++search.steps;
  // Normals may turn slowly into a crease.
  if (look.slope && search.steps == kEarly) search.early_gap = std::max(first, second);
}

/// At the very place of a jump a formula may have a value of its own, as sign(0) is 0. It belongs
/// to neither side, and rounding may give it to some doubles: an end that is far from what is a few
/// places outward goes there. If the last two of those are far from each other, too, the surface
/// goes to infinity.
template <class F>
void look_outward(const Surface& surface, std::span<Search> searches, double delta,
                  unsigned threads, F value) {
  std::vector<Search*> jumps;
  std::vector<dvec2> uv;
  for (Search& search : searches) {
    if (search.found.kind != Break::Jump) continue;
    jumps.push_back(&search);
    const dvec2 step = search.ends[1] - search.ends[0];
    for (const double steps : kOutward) {
      uv.push_back(search.ends[0] - steps * step);
      uv.push_back(search.ends[1] + steps * step);
    }
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  for (std::size_t k = 0; k < jumps.size(); ++k) {
    for (std::size_t end = 0; end < 2; ++end) {
      dvec3 before = jumps[k]->at_ends[end];
      for (std::size_t step = 0; step < kOutward.size(); ++step) {
        const std::size_t next = 2 * (k * kOutward.size() + step) + end;
        const dvec3 outward = value(points[next]);
        if (is_finite(outward) && gap_between(outward, before) >= delta) {
          jumps[k]->found.ends[end] = uv[next];
          if (step + 1 == kOutward.size()) jumps[k]->found.kind = Break::Pole;
        }
        before = outward;
      }
    }
  }
}

/// Finds out the heights at the ends of lines.
template <class H>
void measure_ends(const Surface& surface, std::span<Search> searches,
                  std::span<const std::size_t> which, unsigned threads, H height) {
  std::vector<dvec2> uv;
  for (const std::size_t k : which) {
    uv.insert(uv.end(), searches[k].ends.begin(), searches[k].ends.end());
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  for (std::size_t i = 0; i < which.size(); ++i) {
    Search& search = searches[which[i]];
    search.heights = {height(search, points[2 * i]), height(search, points[2 * i + 1])};
    search.width = 1;
    search.steps = 0;
  }
}

/// Where normals can only jump to their opposites, unit normals that are nearer to each other have
/// no cusp between them, unless the surface turns back by as much as 166 degrees.
constexpr double kNearOpposites = 0.25;

/// What is followed.
template <class F, class H>
struct Followed {
  F value;        ///< the vector that may jump, of a point of the surface
  H height;       ///< what changes its sign where that does, of a search and a point; smooth if any
  double delta;   ///< a gap that is smaller is none
  double beyond;  ///< ends of breaks go on outward to what is this far from them
  bool are_positions;
  int plain;  ///< halvings before heights are known
};

template <class F, class H>
std::vector<Found> follow(const Surface& surface, std::vector<Search> searches,
                          const Followed<F, H>& followed, unsigned threads, std::size_t& work) {
  const auto& [value, height, delta, beyond, are_positions, plain] = followed;
  std::vector<std::size_t> open;
  for (std::size_t k = 0; k < searches.size(); ++k) {
    if (!searches[k].done) open.push_back(k);
  }
  std::vector<dvec2> uv;
  for (int halving = 0; halving < kMaxHalvings && !open.empty(); ++halving) {
    if (halving == plain) measure_ends(surface, searches, open, threads, height);
    uv.clear();
    for (const std::size_t k : open) {
      searches[k].share = next_share(searches[k]);
      const Line& ends = searches[k].ends;
      uv.push_back(ends[0] + searches[k].share * (ends[1] - ends[0]));
    }
    const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
    work += uv.size();
    for (std::size_t i = 0; i < open.size(); ++i) {
      Search& search = searches[open[i]];
      const SurfacePoint& point = points[i];
      const dvec2 way = search.ends[1] - search.ends[0];
      Look look{uv[i], value(point), height(search, point), std::nullopt};
      if (are_positions) look.slope = way.x * point.r_u + way.y * point.r_v;
      advance(search, look, delta);
    }
    std::erase_if(open, [&](std::size_t k) { return searches[k].done; });
  }
  for (const std::size_t k : open) finish(searches[k], at_last_digits(searches[k], delta));
  look_outward(surface, searches, beyond, threads, value);
  std::vector<Found> result(searches.size());
  std::ranges::transform(searches, result.begin(), &Search::found);
  return result;
}

/// Follows positions, which are not known yet.
std::vector<Found> follow_positions(const Surface& surface, std::span<const Line> lines,
                                    double delta, unsigned threads, std::size_t& work) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) uv.insert(uv.end(), line.begin(), line.end());
  const std::vector<SurfacePoint> ends = evaluate(surface, uv, threads);
  std::vector<Search> searches;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    searches.push_back(begin(lines[k], {ends[2 * k].position, ends[2 * k + 1].position}));
  }
  const auto position = [](const SurfacePoint& point) { return point.position; };
  const auto unknown = [](const Search&, const SurfacePoint&) { return kUnknown; };
  work += uv.size();
  const Followed<decltype(position), decltype(unknown)> positions = {
      position, unknown, delta, delta, true, kPlainHalvings};
  return follow(surface, std::move(searches), positions, threads, work);
}

/// Where bounds leave room for breaks beside those that were found. A line with a pole is cut away
/// whole, however many there are.
std::vector<LinePart> suspects(const Surface& surface, std::span<const Line> lines,
                               std::span<const Found> found, double delta, std::size_t& work) {
  std::vector<LinePart> parts;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].kind == Break::None) {
      parts.push_back({k, lines[k]});
    } else if (found[k].kind == Break::Jump) {
      parts.push_back({k, {lines[k][0], found[k].ends[0]}, 1});
      parts.push_back({k, {found[k].ends[1], lines[k][1]}, 0});
    }
  }
  return unproved(surface, std::move(parts), delta, work);
}

/// Whether values between the ends of a gap are not undefined but beyond the largest of doubles, as
/// those of exp(-1/u) before it comes to 0. Then the ends are put where that begins.
bool is_beyond_doubles(const Surface& surface, unsigned threads, Line& ends) {
  const dvec2 middle = between(ends);
  const dvec3 value = evaluate(surface, std::array{middle}, 1)[0].position;
  if (is_finite(value) || glm::any(glm::isnan(value))) return false;
  const std::array<Line, 2> ways = {Line{ends[0], middle}, Line{ends[1], middle}};
  const std::vector<dvec2> last = last_defined(surface, ways, kMaxHalvings, threads);
  ends = {last[0], last[1]};
  return true;
}

/// What there is at suspects. At a pole of even order, where the surface comes back from where it
/// went to, both ends of a gap may be alike.
std::vector<Found> look_at(const Surface& surface, std::span<const Line> lines,
                           std::span<const LinePart> suspects, double delta, unsigned threads,
                           std::size_t& work) {
  std::vector<Line> parts;
  std::vector<Line> ways;
  for (const auto& [line, part, broken_end] : suspects) {
    parts.push_back(part);
    ways.push_back({part[0], lines[line][0]});
    ways.push_back({part[1], lines[line][1]});
  }
  std::vector<Found> found = follow_positions(surface, parts, delta, threads, work);
  const std::vector<bool> far = diverge(surface, ways, delta, threads);
  work += kApproach.size() * ways.size();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const bool is_pole = far[2 * i] || far[2 * i + 1];
    if (found[i].kind == Break::None) found[i].ends = parts[i];
    // A place where the surface is not defined is no pole: sin(1/u) goes nowhere.
    if (is_pole) found[i].kind = Break::Pole;
    if (!is_pole && found[i].kind == Break::Pole &&
        !is_beyond_doubles(surface, threads, found[i].ends)) {
      found[i].kind = Break::None;
    }
  }
  return found;
}

/// A gap also grows if the ends of its line happen to be alike, a whole step of a saw's teeth from
/// each other: a pole is where the surface goes to infinity.
void verify_poles(const Surface& surface, std::span<const Line> lines, double delta,
                  unsigned threads, std::span<Found> found) {
  std::vector<std::size_t> poles;
  std::vector<Line> ways;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].kind != Break::Pole) continue;
    poles.push_back(k);
    for (std::size_t end = 0; end < 2; ++end) ways.push_back({found[k].ends[end], lines[k][end]});
  }
  const std::vector<bool> far = diverge(surface, ways, delta, threads);
  for (std::size_t i = 0; i < poles.size(); ++i) {
    if (far[2 * i] || far[2 * i + 1]) continue;
    Line& ends = found[poles[i]].ends;
    if (is_beyond_doubles(surface, threads, ends)) continue;
    const dvec2 middle = between(ends);
    const auto length = [](const Line& line) { return glm::distance(line[0], line[1]); };
    const bool is_gap = (middle == ends[0] || middle == ends[1]) &&
                        length(ends) <= kSamePlace * length(lines[poles[i]]);
    found[poles[i]].kind = is_gap ? Break::Jump : Break::None;
  }
}

}  // namespace

namespace {

/// Adds what was found at a suspect to what is known of its line.
void add(const Found& more, const Line& line, Found& known) {
  if (more.kind == Break::None) return;
  const double apart = glm::distance(known.ends[0], more.ends[0]);
  if (known.kind == Break::None) {
    known = more;
  } else if (apart > kSamePlace * glm::distance(line[0], line[1])) {
    known.has_more = true;
  } else if (more.kind == Break::Pole) {
    known.kind = Break::Pole;
  }
}

/// Takes a few suspects of each line, those beside a known break first, that does not have more
/// breaks than one anyway. `open`: in the order of lines; those that are taken are left out.
std::vector<LinePart> take_some(std::span<const Found> found, std::vector<LinePart>& open) {
  constexpr std::size_t kAtATime = 2;
  std::erase_if(open, [&](const LinePart& part) { return found[part.line].has_more; });
  std::vector<LinePart> taken;
  std::vector<LinePart> rest;
  std::size_t count = 0;  // of the line
  for (std::size_t k = 0; k < open.size(); ++k) {
    if (k == 0 || open[k].line != open[k - 1].line) count = 0;
    (count++ < kAtATime ? taken : rest).push_back(open[k]);
  }
  open = std::move(rest);
  return taken;
}

/// Breaks of lines that may have some.
std::vector<Found> find_breaks_in(const Surface& surface, std::span<const Line> lines, double delta,
                                  unsigned threads, std::size_t& work) {
  std::vector<Found> found = follow_positions(surface, lines, delta, threads, work);
  verify_poles(surface, lines, delta, threads, found);
  std::vector<LinePart> open = suspects(surface, lines, found, delta, work);
  const auto from_break = [&](const LinePart& part) {
    const Found& known = found[part.line];
    return known.kind == Break::None ? 0 : glm::distance(part.part[0], known.ends[0]);
  };
  std::ranges::stable_sort(open, [&](const LinePart& a, const LinePart& b) {
    return a.line != b.line ? a.line < b.line : from_break(a) < from_break(b);
  });
  while (true) {
    const std::vector<LinePart> some = take_some(found, open);
    if (some.empty()) return found;
    const std::vector<Found> more = look_at(surface, lines, some, delta, threads, work);
    for (std::size_t i = 0; i < some.size(); ++i) {
      add(more[i], lines[some[i].line], found[some[i].line]);
    }
  }
}

}  // namespace

std::vector<Found> find_breaks(const Surface& surface, std::span<const Line> lines, double delta,
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
  std::vector<Found> result(lines.size());
  const std::vector<Found> found = find_breaks_in(surface, open_lines, delta, threads, work);
  for (std::size_t i = 0; i < open.size(); ++i) result[open[i]] = found[i];
  return result;
}

namespace {

/// What the shares of a short way are multiplied by, so that the nearest place is some digits from
/// its end.
double widening(const Line& line) {
  constexpr double kDigits = 256 * std::numeric_limits<double>::epsilon();
  constexpr double kMost = 0.5 / kApproach.front();
  const dvec2 way = glm::abs(line[1] - line[0]);
  const dvec2 end = glm::abs(line[0]);
  const double length = std::max(way.x, way.y);
  const double place = way.x > way.y ? end.x : end.y;
  if (!(length > 0)) return 1;
  return std::clamp(kDigits * place / (kApproach.back() * length), 1.0, kMost);
}

/// Of positions in the box between two places.
std::array<Interval, 3> bounds_between(Enclosure& enclosure, const dvec2& a, const dvec2& b) {
  std::array<Interval, 3> bounds;
  enclosure(range_between(a.x, b.x), range_between(a.y, b.y), bounds);
  return bounds;
}

/// Whether bounds tell that the surface does not go beyond what it is farther away when it comes
/// nearer to a line's first end, as cos(1/u) does not, however it moved between some places. What
/// arrives somewhere may go as far again as it went there.
bool stays_within(Enclosure& enclosure, const Line& line) {
  const double wider = widening(line);
  const auto place = [&](std::size_t i) {
    return line[0] + wider * kApproach[i] * (line[1] - line[0]);
  };
  const auto outer = bounds_between(enclosure, place(0), place(1));
  const std::size_t last = kApproach.size() - 1;
  const auto inner = bounds_between(enclosure, place(last - 1), place(last));
  const auto is_within = [](const Interval& a, const Interval& b) {
    const double size = b.high - b.low;
    return std::isfinite(size) && a.low >= b.low - size && a.high <= b.high + size;
  };
  return std::ranges::equal(inner, outer, is_within);
}

}  // namespace

std::vector<bool> diverge(const Surface& surface, std::span<const Line> lines, double delta,
                          unsigned threads) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) {
    const double wider = widening(line);
    for (const double share : kApproach)
      uv.push_back(line[0] + wider * share * (line[1] - line[0]));
  }
  const auto points = evaluate(surface, uv, threads);
  std::optional<Enclosure> enclosure;
  std::vector<bool> result;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const std::size_t begin = k * kApproach.size();
    double size = delta;  // squares of what is near the largest of doubles would overflow
    for (std::size_t i = 0; i < kApproach.size(); ++i) {
      size = std::max(size, safe_length(points[begin + i].position));
    }
    const auto way = [&](std::size_t i) {
      const std::size_t first = begin + i;
      return points[first + 1].position / size - points[first].position / size;
    };
    bool goes_on = kStepsLeft * glm::length(way(kApproach.size() - 2)) > delta / size;
    for (std::size_t i = 0; i + 2 < kApproach.size(); ++i) {
      const double before = glm::length(way(i));
      goes_on = goes_on && glm::dot(way(i), way(i + 1)) >= kArrives * before * before;
    }
    if (goes_on && !enclosure) enclosure.emplace(surface.bounds, 3);
    result.push_back(goes_on && !stays_within(*enclosure, lines[k]));
  }
  return result;
}

std::vector<Found> find_creases(const Surface& surface, std::span<const Line> lines,
                                std::span<const std::array<dvec3, 2>> normals, unsigned threads,
                                std::size_t& work) {
  const double chord = 2 * std::sin(0.5 * kCreaseDegrees * std::numbers::pi / 180);
  const auto [open, only_cusps] = unproved_normals(surface, lines, work);
  std::vector<Search> searches;
  searches.reserve(open.size());
  for (const std::size_t k : open) searches.push_back(begin(lines[k], normals[k]));
  const auto normal = [](const SurfacePoint& point) {
    return normal_direction(point).value_or(dvec3(kUnknown));
  };
  const auto height = [&](const Search& search, const SurfacePoint& point) {
    return glm::dot(glm::cross(point.r_u, point.r_v), search.at_ends[0] - search.at_ends[1]);
  };
  const Followed<decltype(normal), decltype(height)> turning = {
      normal, height, only_cusps ? kNearOpposites : chord,
      chord,  false,  only_cusps ? kPlainHalvingsOfCusps : kPlainHalvings};
  const std::vector<Found> found = follow(surface, std::move(searches), turning, threads, work);
  std::vector<Found> result(lines.size());
  for (std::size_t i = 0; i < open.size(); ++i) {
    result[open[i]] = found[i];
    result[open[i]].is_cusp = only_cusps && found[i].kind != Break::None;
  }
  return result;
}

std::vector<dvec2> last_defined(const Surface& surface, std::span<const Line> lines, int halvings,
                                unsigned threads, const std::optional<Bounds>& box) {
  std::vector<Line> ends(lines.begin(), lines.end());
  std::vector<std::size_t> open(lines.size());
  std::iota(open.begin(), open.end(), std::size_t{0});
  std::vector<dvec2> middles;
  for (int halving = 0; halving < halvings && !open.empty(); ++halving) {
    middles.clear();
    for (const std::size_t k : open) middles.push_back(0.5 * ends[k][0] + 0.5 * ends[k][1]);
    const auto points = evaluate(surface, middles, threads);
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < open.size(); ++i) {
      Line& line = ends[open[i]];
      const bool is_last = middles[i] == line[0] || middles[i] == line[1];  // no doubles between
      const dvec3& p = points[i].position;
      line[is_finite(p) && (!box || box->contains(p)) ? 0 : 1] = middles[i];
      if (!is_last) rest.push_back(open[i]);
    }
    open = std::move(rest);
  }
  std::vector<dvec2> last(ends.size());
  std::ranges::transform(ends, last.begin(), [](const Line& line) { return line[0]; });
  return last;
}

}  // namespace saddle
