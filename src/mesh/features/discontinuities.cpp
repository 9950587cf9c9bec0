#include "mesh/features/discontinuities.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include <glm/common.hpp>

#include "mesh/features/approach.h"
#include "mesh/features/jumps_and_poles.h"
#include "mesh/features/narrow_parts.h"
#include "mesh/features/search_chunks.h"
#include "mesh/model/tolerances.h"
#include "mesh/proof/continuity.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Jumps of lines, in their order: they have no place in common.
using JumpsOfLines = std::vector<std::vector<Line>>;

/// Appends the part of a line between two known discontinuities, or ends of the line: as two parts
/// if it is between discontinuities.
void append_between(std::size_t line, const Line& part, bool is_first_known, bool is_last_known,
                    std::vector<LinePart>& parts) {
  if (part[0] == part[1]) return;
  if (is_first_known && is_last_known) {
    const dvec2 middle = near_middle(part);
    parts.push_back({line, {part[0], middle}, 0});
    parts.push_back({line, {middle, part[1]}, 1});
  } else {
    parts.push_back({line, part});
    if (is_first_known) parts.back().broken_end = 0;
    if (is_last_known) parts.back().broken_end = 1;
  }
}

/// A way from a jump of a line to the next known one, or to an end of the line.
struct WayFromJump {
  std::size_t line;
  Line way;
  bool is_forward;  ///< in the direction of the line
};

/// The parts of ways in which there are steps that slopes do not explain: other jumps, nearer than
/// bounds tell. Places are looked at 4 times as near each, and down to kSame.
std::vector<LinePart> steps_on(const Surface& surface, std::span<const WayFromJump> ways,
                               double delta, std::size_t& work) {
  constexpr double kNearer = 0.25;
  std::vector<double> shares = {1};  // of the way from the jump
  while (shares.back() > kSame) shares.push_back(kNearer * shares.back());
  shares.push_back(0);
  std::vector<dvec2> uv;
  for (const auto& [line, way, is_forward] : ways) {
    for (const double share : shares) uv.push_back(glm::mix(way[0], way[1], share));
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, 1);
  work += uv.size();
  std::vector<LinePart> parts;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const std::size_t first = k * shares.size();
    for (std::size_t j = first; j + 1 < first + shares.size(); ++j) {
      const dvec2 way = uv[j + 1] - uv[j];
      const auto slope = [&](const SurfacePoint& p) { return way.x * p.r_u + way.y * p.r_v; };
      const dvec3 step = points[j + 1].position - points[j].position;
      const double gap = glm::length(step - 0.5 * (slope(points[j]) + slope(points[j + 1])));
      if (!(gap > delta)) continue;
      const Line part = {uv[j], uv[j + 1]};
      parts.push_back({ways[k].line, ways[k].is_forward ? Line{part[1], part[0]} : part});
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

/// The line between two parts of a line that have no place in common.
Line between(const Line& a, const Line& b, const Line& line) {
  const bool is_first = glm::distance(line[0], a[0]) < glm::distance(line[0], b[0]);
  return is_first ? Line{a[1], b[0]} : Line{b[1], a[0]};
}

/// Discontinuities of a line this near to each other are one. Rounding makes false poles and jumps
/// beside a pole: as far as kBesidePole, and where it moves a parameter by e, values change by more
/// than the tolerance as far from the pole as about the square root of e times the line's length.
double same_of(const Line& line, const dvec2& range, bool is_pole) {
  const double length = length_of(line);
  const double same = kSame * length;
  if (!is_pole) return same;
  double rounding = 0;
  for (int k = 0; k < 2; ++k) {
    if (line[0][k] == line[1][k]) continue;
    const double size = std::max(std::fabs(line[0][k]), std::fabs(line[1][k]));
    rounding = std::max(rounding, kRounding * size);
  }
  const double beside_pole = kBesidePole.back() * length / length_in_ranges(line, range);
  return std::max({same, beside_pole, std::sqrt(rounding) * std::sqrt(length)});
}

/// Whether two discontinuities begin or end at one place, as all do that rounding makes beside a
/// value of its own at an end of their line.
bool share_end(const Line& a, const Line& b) {
  return a[0] == b[0] || a[1] == b[1];
}

/// Adds a discontinuity in an unproved part to the known one of its line.
void add(const LocatedDiscontinuity& more, const Line& line, const dvec2& range,
         LocatedDiscontinuity& known) {
  if (more.kind == Discontinuity::None) return;
  const Line gap = between(known.ends, more.ends, line);
  const bool is_pole = known.kind == Discontinuity::Pole || more.kind == Discontinuity::Pole;
  if (known.kind == Discontinuity::None) {
    known = more;
  } else if (!share_end(more.ends, known.ends) && length_of(gap) > same_of(line, range, is_pole)) {
    known.between = middle_of(gap);
  } else if (more.kind == Discontinuity::Pole) {
    known.kind = Discontinuity::Pole;
    if (length_of(more.ends) < length_of(known.ends)) known.ends = more.ends;
  } else {
    known.ends = hull(known.ends, more.ends, line);
  }
}

/// Searches lines that are not proved to be continuous.
class LineSearch {
 public:
  LineSearch(const Surface& surface, SurfaceEnclosure& enclosure, std::span<const Line> lines,
             double delta, std::size_t& work)
      : surface_(surface),
        enclosure_(enclosure),
        lines_(lines),
        delta_(delta),
        work_(work),
        found_(follow_lines(surface, lines, delta, 1, work)),
        jumps_(lines.size()),
        is_full_(lines.size()),
        is_complete_(lines.size()) {}

  std::vector<LocatedDiscontinuity> run() {
    follow_steps();
    const std::vector<LinePart> open = unproved_parts();
    look(open);
    note_complete(open);
    add_all();
    return std::move(found_);
  }

 private:
  /// Rounds of steps beside jumps that steps led to: those of a difference of differences.
  static constexpr int kStepRounds = 3;

  /// Finds the jumps to which steps beside known jumps lead. Where there are others, proofs take
  /// tens of boxes for each.
  void follow_steps() {
    std::vector<WayFromJump> ways;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (found_[k].kind == Discontinuity::Jump) add_jump(k, found_[k].ends, ways);
    }
    for (int round = 0; round < kStepRounds && !ways.empty(); ++round) {
      const auto steps = steps_on(surface_, std::exchange(ways, {}), delta_, work_);
      const std::size_t first = more_.size();
      look(steps);
      for (std::size_t i = first; i < more_.size(); ++i) {
        if (more_[i].kind == Discontinuity::Jump) add_jump(parts_[i].line, more_[i].ends, ways);
      }
    }
  }

  /// The parts of lines that bounds do not prove to be continuous, beside the discontinuities found
  /// so far. A line with a pole has none: all of it is cut away.
  std::vector<LinePart> unproved_parts() {
    std::vector<LinePart> parts;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (found_[k].kind == Discontinuity::Pole) continue;
      dvec2 from = lines_[k][0];
      bool is_known = false;
      for (const Line& jump : jumps_[k]) {
        append_between(k, {from, jump[0]}, is_known, true, parts);
        from = jump[1];
        is_known = true;
      }
      append_between(k, {from, lines_[k][1]}, is_known, false, parts);
    }
    parts = unproved(enclosure_, std::move(parts), delta_, work_, kHalvingsToSame);
    return narrowed(surface_, enclosure_, lines_, parts, delta_, work_);
  }

  /// Looks at parts of lines.
  void look(const std::vector<LinePart>& parts) {
    const auto at = look_at(surface_, lines_, parts, delta_, 1, work_);
    parts_.insert(parts_.end(), parts.begin(), parts.end());
    more_.insert(more_.end(), at.begin(), at.end());
  }

  /// Adds a jump to those of its line, and the ways from it if it is a new one.
  void add_jump(std::size_t number, const Line& jump, std::vector<WayFromJump>& ways) {
    const Line& line = lines_[number];
    std::vector<Line>& jumps = jumps_[number];
    const double same = kSame * length_of(line);
    const auto is_same = [&](const Line& at) {
      return glm::distance(at[0], jump[0]) <= same || share_end(at, jump);
    };
    const auto known = std::ranges::find_if(jumps, is_same);
    if (known != jumps.end()) {
      *known = hull(*known, jump, line);
      return;
    }
    const auto next = std::ranges::find_if(jumps, [&](const Line& at) {
      return glm::distance(line[0], at[0]) > glm::distance(line[0], jump[0]);
    });
    if (jumps.size() == kMostLineParts) {  // there are waves
      is_full_[number] = true;
      return;
    }
    ways.push_back(
        {number, {jump[0], next == jumps.begin() ? line[0] : (*std::prev(next))[1]}, false});
    ways.push_back({number, {jump[1], next == jumps.end() ? line[1] : (*next)[0]}, true});
    jumps.insert(next, jump);
  }

  /// Notes the lines whose jumps are all known: there is no pole, longer unproved parts than kSame
  /// show no jump when they are looked at, and those as short are few but beside known jumps. The
  /// parts that were looked at last are `open`.
  void note_complete(std::span<const LinePart> open) {
    for (std::size_t k = 0; k < lines_.size(); ++k)
      is_complete_[k] = found_[k].kind == Discontinuity::Jump && !is_full_[k];
    std::vector<std::size_t> counts(lines_.size(), 0);
    std::vector<std::size_t> all(lines_.size(), 0);
    std::vector<bool> is_unclear(lines_.size(), false);
    const std::size_t first = more_.size() - open.size();
    for (std::size_t i = 0; i < open.size(); ++i) {
      const LinePart& part = open[i];
      const bool is_short = length_of(part.part) <= kSame * length_of(lines_[part.line]);
      if (is_short && !part.broken_end) ++counts[part.line];
      const bool is_jump = more_[first + i].kind != Discontinuity::None;
      // A place with a value of its own is no jump of the line, but may be one of its halves.
      if (!is_short || (!is_jump && !part.broken_end)) is_unclear[part.line] = true;
      ++all[part.line];
      if ((!is_short && is_jump) || counts[part.line] == kMostLineParts)
        is_complete_[part.line] = false;
    }
    std::vector<WayFromJump> unused;
    for (std::size_t i = 0; i < more_.size(); ++i) {
      const std::size_t k = parts_[i].line;
      if (more_[i].kind == Discontinuity::Pole) is_complete_[k] = false;
      if (more_[i].kind == Discontinuity::Jump) add_jump(k, more_[i].ends, unused);
      if (is_full_[k]) is_complete_[k] = false;
    }
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      found_[k].is_proved = is_complete_[k] && !is_unclear[k] && all[k] < kMostLineParts;
      found_[k].has_waves = is_full_[k];
    }
  }

  /// Adds discontinuities to those that lines were known to have first, the nearest ones first.
  void add_all() {
    std::vector<std::size_t> order(more_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto from_known = [&](std::size_t i) {
      const LocatedDiscontinuity& known = found_[parts_[i].line];
      return known.kind == Discontinuity::None ? 0
                                               : glm::distance(parts_[i].part[0], known.ends[0]);
    };
    std::vector<double> distances(more_.size());
    std::ranges::transform(order, distances.begin(), from_known);
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
      return std::pair(parts_[a].line, distances[a]) < std::pair(parts_[b].line, distances[b]);
    });
    const dvec2 range = box_of(surface_.domain).size();
    for (const std::size_t i : order)
      add(more_[i], lines_[parts_[i].line], range, found_[parts_[i].line]);
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      if (is_complete_[k]) found_[k].jumps = std::move(jumps_[k]);
    }
  }

  const Surface& surface_;
  SurfaceEnclosure& enclosure_;  // of positions
  std::span<const Line> lines_;
  double delta_;
  std::size_t& work_;
  std::vector<LocatedDiscontinuity> found_;
  JumpsOfLines jumps_;
  std::vector<bool> is_full_;               ///< the line has more jumps than are kept
  std::vector<bool> is_complete_;           ///< the line has no other jumps
  std::vector<LinePart> parts_;             ///< that were looked at
  std::vector<LocatedDiscontinuity> more_;  ///< found in them
};

std::vector<LocatedDiscontinuity> discontinuities_of_some(const Surface& surface,
                                                          std::span<const Line> lines, double delta,
                                                          std::size_t& work) {
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  std::vector<LinePart> whole;
  for (std::size_t k = 0; k < lines.size(); ++k) whole.push_back({k, lines[k]});
  std::vector<std::size_t> open;
  std::vector<Line> open_lines;
  for (const LinePart& part : unproved(enclosure, std::move(whole), delta, work, kFirstHalvings)) {
    if (!open.empty() && open.back() == part.line) continue;
    open.push_back(part.line);
    open_lines.push_back(lines[part.line]);
  }
  std::vector<LocatedDiscontinuity> result(lines.size());
  for (LocatedDiscontinuity& at : result) at.is_proved = true;
  auto found = LineSearch(surface, enclosure, open_lines, delta, work).run();
  for (std::size_t k = 0; k < found.size(); ++k) result[open[k]] = std::move(found[k]);
  return result;
}

}  // namespace

std::vector<LocatedDiscontinuity> find_discontinuities(const Surface& surface,
                                                       std::span<const Line> lines, double delta,
                                                       unsigned threads, std::size_t& work) {
  return search_chunks(lines, kSearchedTogether, threads, work,
                       [&](std::span<const Line> some, std::size_t& own) {
                         return discontinuities_of_some(surface, some, delta, own);
                       });
}

std::vector<std::vector<Line>> find_all_jumps(const Surface& surface, std::span<const Line> lines,
                                              std::span<const LocatedDiscontinuity> found,
                                              double delta, unsigned threads, std::size_t& work) {
  JumpsOfLines jumps(lines.size());
  std::vector<std::size_t> numbers;  // of the lines of parts that were not searched
  std::vector<Line> parts;
  const auto split = [&](std::size_t k, const Line& part, const LocatedDiscontinuity& at) {
    if (at.kind != Discontinuity::Jump || at.has_waves || jumps[k].size() == kMostLineParts) {
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
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (found[k].jumps.empty()) {
      split(k, lines[k], found[k]);
    } else {
      jumps[k] = found[k].jumps;
    }
  }
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

}  // namespace saddle
