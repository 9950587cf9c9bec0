#include "mesh/proof/continuity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/normal.h"

namespace saddle {

namespace {

/// After 6 halvings of a line, more than kMostLineParts open parts end the search: as many of them
/// stand for all.
constexpr int kLeastHalvings = 6;
/// Where nothing is proved of a line after 2 halvings, bounds are tried on 3 boxes as short as
/// parts after 6. If they prove nothing there, they are too wide for the whole line.
constexpr int kHalvingsToGlance = 2;
constexpr std::array kGlances = {0.21, 0.53, 0.83};
/// Halvings at once toward an end of a part that is never proved: a known discontinuity is beside
/// it, or the last kLeastHalvings cuts left that end alone. The rest is halved on where bounds are
/// too wide.
constexpr int kHalvingsBeside = 10;

ParameterBox box_around(std::span<const LinePart> lines) {
  ParameterBox box = {lines[0].part[0], lines[0].part[0]};
  for (const LinePart& line : lines) {
    for (const dvec2& end : line.part) box = {glm::min(box.low, end), glm::max(box.high, end)};
  }
  return box;
}

/// Whether a box around lines is wider in u than in v, in mean sizes of the lines: u and v have
/// units of their own.
bool is_wider_along_u(std::span<const LinePart> lines, const dvec2& size) {
  dvec2 sum(0);
  for (const LinePart& line : lines) sum += glm::abs(line.part[1] - line.part[0]);
  return size.x * sum.y >= size.y * sum.x;
}

/// Proves many lines at a time, by is_proved(box around them, number of lines); without a proof it
/// goes on with both halves of the lines. Calls leave(lines) of groups of at most few() lines.
/// Changes the lines' order.
template <class Few, class IsProved, class Leave>
void prove_together(std::span<LinePart> lines, Few few, IsProved is_proved, Leave leave) {
  if (lines.size() <= few()) return leave(lines);
  const ParameterBox box = box_around(lines);
  if (is_proved(box, lines.size())) return;
  const int axis = is_wider_along_u(lines, box.size()) ? 0 : 1;
  const auto place = [&](const LinePart& line) { return line.part[0][axis] + line.part[1][axis]; };
  const std::size_t half = lines.size() / 2;
  std::ranges::nth_element(lines, lines.begin() + static_cast<std::ptrdiff_t>(half), {}, place);
  prove_together(lines.first(half), few, is_proved, leave);
  prove_together(lines.subspan(half), few, is_proved, leave);
}

/// The number between two that has the fewest binary digits after the point.
double shortest_between(double low, double high) {
  if (low <= 0 && high >= 0) return 0;
  double digit = std::ldexp(1, std::ilogb(high - low));  // of the last place
  double shortest = low;
  for (double next = std::ceil(low / digit) * digit; next <= high;
       digit *= 2, next = std::ceil(low / digit) * digit)
    shortest = next;
  return shortest;
}

class Prover {
 public:
  Prover(SurfaceEnclosure& enclosure, double delta, int halvings)
      : enclosure_(enclosure), delta_(delta), halvings_(halvings) {}

  /// Number of boxes tested.
  std::size_t boxes() const { return boxes_; }

  /// Appends the unproved parts of lines to `result`. Changes the lines' order.
  void prove(std::span<LinePart> lines, std::vector<LinePart>& result) {
    prove_together(
        lines, [] { return std::size_t{1}; },
        [this](const ParameterBox& box, std::size_t) { return is_proved(box); },
        [&](std::span<const LinePart> one) {
          for (const LinePart& line : one) add_unproved(line, result);
        });
  }

 private:
  /// A part without a proof so far.
  struct Open {
    LinePart line;
    int depth = 0;            ///< halvings that make a part as short
    std::size_t towards = 0;  ///< the end of the part before that it lies at
    int steady = 0;           ///< cuts in a row after which the part at that end was left alone
    bool was_tested = false;
  };

  /// As near to an end of a line as so many halvings; nothing if there are no doubles between.
  static std::optional<dvec2> place_near(const Line& line, std::size_t end, int halvings) {
    const double near = std::ldexp(1, -halvings);
    const double share = end == 0 ? near : 1 - near;
    const dvec2 at = (1 - share) * line[0] + share * line[1];
    return at == line[0] || at == line[1] ? std::nullopt : std::optional(at);
  }

  /// Cuts a part in two; nothing if it is as short as doubles go.
  std::optional<std::array<Open, 2>> cut(const Open& whole) const {
    const auto& [line, part, broken] = whole.line;
    if (broken) {
      const std::optional<dvec2> at = place_near(part, *broken, kHalvingsBeside);
      return at ? std::optional(cut_at(*at, whole, 1)) : std::nullopt;
    }
    if (whole.steady >= kLeastHalvings) {
      const int times = std::min(kHalvingsBeside, halvings_ - whole.depth);
      if (const auto at = place_near(part, whole.towards, times)) return cut_at(*at, whole, times);
    }
    const std::optional<dvec2> at = place_near(part, 0, 1);
    return at ? std::optional(cut_at(*at, whole, 1)) : std::nullopt;
  }

  /// `times`: the halvings that the part at the end without a proof counts for.
  static std::array<Open, 2> cut_at(const dvec2& at, const Open& whole, int times) {
    const auto& [line, part, broken] = whole.line;
    std::array<Open, 2> parts = {Open{{line, {part[0], at}}}, Open{{line, {at, part[1]}}}};
    for (std::size_t k = 0; k < 2; ++k) {
      parts[k].depth = whole.depth + (times == 1 ? 1 : k == whole.towards ? times : 0);
      parts[k].towards = k;
      if (k == whole.towards) parts[k].steady = whole.steady;
    }
    if (broken) parts[*broken].line.broken_end = broken;
    return parts;
  }

  /// Removes the parts that are proved. A part that is left alone of two is one cut steadier.
  void keep_unproved(std::vector<Open>& level) {
    const auto are_halves = [](const Open& a, const Open& b) {
      return a.towards == 0 && b.towards == 1 && a.line.part[1] == b.line.part[0];
    };
    std::erase_if(level, [this](const Open& open) {
      return !open.was_tested && open.depth < halvings_ &&
             is_proved({open.line.part[0], open.line.part[1]});
    });
    for (std::size_t k = 0; k < level.size(); ++k) {
      const bool is_alone = !(k > 0 && are_halves(level[k - 1], level[k])) &&
                            !(k + 1 < level.size() && are_halves(level[k], level[k + 1]));
      level[k].steady = is_alone ? level[k].steady + 1 : 0;
    }
  }

  /// The parts of a line that are searched. Jumps of formulas are at short numbers and along lines
  /// of the root grid: where a line of constant u or v has one at an end, or at the shortest number
  /// between, this adds a few doubles around it to `jumps`, and the search goes on beside them.
  std::vector<Open> parts_beside_short_numbers(const LinePart& line, std::vector<LinePart>& jumps) {
    const dvec2& a = line.part[0];
    const dvec2& b = line.part[1];
    if (line.broken_end || (a.x == b.x) == (a.y == b.y)) return {{line}};
    const int axis = a.x == b.x ? 1 : 0;
    const auto part_between = [&](double from, double to) {
      Line part = {a, a};
      part[0][axis] = from;
      part[1][axis] = to;
      return part;
    };
    const auto are_proved = [&](double from, double to) {
      const auto [first, last] = part_between(from, to);
      return from == to || is_proved({first, last});
    };
    const double from = a[axis];
    const double to = b[axis];
    const double beside = std::ldexp(to - from, -kLeastHalvings);
    const auto place = [&](double at, double offset) {
      return std::clamp(at + offset, std::min(from, to), std::max(from, to));
    };
    std::vector<Open> parts;
    double begin = from;
    for (const double at : {from, shortest_between(std::min(from, to), std::max(from, to)), to}) {
      // Bounds round the formula of a jump's place. Doubles beside 0 go on.
      const double rounding = std::copysign(kRounding * at, beside);
      if (!(std::fabs(rounding) < std::fabs(beside))) continue;
      const double before = place(at, -rounding);
      const double behind = place(at, rounding);
      const bool is_passed = (before - begin) * (to - from) < 0;
      if (is_passed || are_proved(before, behind) || !are_proved(place(at, -beside), before) ||
          !are_proved(behind, place(at, beside)))
        continue;
      if (begin != before) parts.push_back({{line.line, part_between(begin, before)}});
      jumps.push_back({line.line, part_between(before, behind)});
      begin = behind;
    }
    if (begin != to) parts.push_back({{line.line, part_between(begin, to)}});
    return parts;
  }

  void add_unproved(const LinePart& line, std::vector<LinePart>& result) {
    if (is_proved({line.part[0], line.part[1]})) return;
    std::vector<LinePart> rest;
    std::vector<Open> level = parts_beside_short_numbers(line, rest);
    if (rest.empty()) level[0].was_tested = true;  // it is the whole line
    for (int cuts = 0; !level.empty(); ++cuts) {
      keep_unproved(level);
      const bool is_in_vain = cuts == kHalvingsToGlance && level.size() == 1 << kHalvingsToGlance &&
                              !is_provable(line.part);
      if (level.size() > kMostLineParts && cuts >= kLeastHalvings) break;
      std::vector<Open> next;
      for (const Open& open : level) {
        const auto parts = open.depth < halvings_ ? cut(open) : std::nullopt;
        if (parts) {
          next.insert(next.end(), parts->begin(), parts->end());
        } else {
          rest.push_back(open.line);
        }
      }
      level = std::move(next);
      if (is_in_vain) break;
    }
    for (const Open& open : level) rest.push_back(open.line);
    add_some(joined(std::move(rest), line), result);
  }

  /// Whether there is a proof on short boxes of a line.
  bool is_provable(const Line& line) {
    const dvec2 length = (line[1] - line[0]) / static_cast<double>(1 << kLeastHalvings);
    return std::ranges::any_of(kGlances, [&](double share) {
      const dvec2 at = glm::mix(line[0], line[1], share);
      return is_proved({at, at + length});
    });
  }

  /// Joins parts that touch. Jumps as near to each other as kSame are one: bounds are too
  /// wide for a proof on both sides of it.
  static std::vector<LinePart> joined(std::vector<LinePart> parts, const LinePart& whole) {
    const dvec2 first = whole.part[0];
    const double longest = kSame * glm::distance(first, whole.part[1]);
    std::ranges::sort(parts, {},
                      [&](const LinePart& part) { return glm::distance(first, part.part[0]); });
    std::vector<LinePart> result;
    for (const LinePart& part : parts) {
      const bool is_joined = !result.empty() && result.back().part[1] == part.part[0] &&
                             glm::distance(result.back().part[0], part.part[1]) <= longest;
      if (!is_joined) {
        result.push_back(part);
        continue;
      }
      result.back().part[1] = part.part[1];
      if (part.broken_end) result.back().broken_end = part.broken_end;
    }
    return result;
  }

  static void add_some(std::span<const LinePart> parts, std::vector<LinePart>& result) {
    const std::size_t step = (parts.size() + kMostLineParts - 1) / kMostLineParts;
    for (std::size_t k = 0; k < parts.size(); k += step) result.push_back(parts[k]);
  }

  bool is_proved(const ParameterBox& box) {
    ++boxes_;
    const std::span<const Interval> position = enclosure_.enclose(box);
    bool is_continuous = true;
    dvec3 size;
    for (int k = 0; k < 3; ++k) {
      const Interval& a = position[static_cast<std::size_t>(k)];
      if (a.defined != Defined::Yes) return false;
      is_continuous = is_continuous && a.continuous;
      size[k] = a.high - a.low;
    }
    return is_continuous || glm::length(size) < delta_;
  }

  SurfaceEnclosure& enclosure_;
  double delta_;
  int halvings_;
  std::size_t boxes_ = 0;
};

/// Proves that the normal is defined and continuous in a box. |r_u x r_v| must exceed its rounding:
/// on u = 2 pi a sphere has a cross product by rounding alone.
class NormalProver {
 public:
  explicit NormalProver(const Surface& surface) : enclosure_(surface, Bounded::Tangents) {}

  bool has_continuous_tangents(const ParameterBox& box) {
    return are_continuous(enclosure_.enclose(box));
  }

  bool is_proved(const ParameterBox& box) { return has_continuous_tangents(box) && has_normals(); }

  /// Whether r_u x r_v is not 0 in the last box.
  bool has_normals() const {
    const std::span<const Interval> r_u = enclosure_.last().subspan(3, 3);
    const std::span<const Interval> r_v = enclosure_.last().subspan(6, 3);
    const double least = kDegenerateCross * longest(r_u) * longest(r_v);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = (k + 1) % 3;
      const std::size_t j = (k + 2) % 3;
      const Interval area = r_u[i] * r_v[j] - r_u[j] * r_v[i];
      if (area.low > least || area.high < -least) return true;  // not so for NaN
    }
    return false;
  }

 private:
  /// An upper bound of a vector's length.
  static double longest(std::span<const Interval> vector) {
    dvec3 most;
    for (int k = 0; k < 3; ++k) {
      const Interval& a = vector[static_cast<std::size_t>(k)];
      most[k] = std::max(std::fabs(a.low), std::fabs(a.high));
    }
    return glm::length(most);
  }

  SurfaceEnclosure enclosure_;
};

}  // namespace

std::vector<LinePart> unproved(SurfaceEnclosure& enclosure, std::vector<LinePart> lines,
                               double delta, std::size_t& boxes, int halvings) {
  std::vector<LinePart> result;
  Prover prover(enclosure, delta, halvings);
  prover.prove(lines, result);
  boxes += prover.boxes();
  std::ranges::stable_sort(result, {}, &LinePart::line);
  return result;
}

UnprovedNormals unproved_normals(const Surface& surface, std::span<const Line> lines,
                                 Patience& patience, std::size_t& boxes) {
  /// A search on 4 lines takes less time than proofs.
  constexpr std::size_t kFew = 4;
  UnprovedNormals result;
  if (lines.empty()) return result;
  std::vector<LinePart> all;
  for (std::size_t k = 0; k < lines.size(); ++k) all.push_back({k, lines[k]});
  NormalProver prover(surface);
  ++boxes;
  result.only_cusps = prover.has_continuous_tangents(box_around(all));
  if (result.only_cusps && prover.has_normals()) {
    patience.learn(true);
    return result;
  }
  std::size_t stagnation = 0;
  std::size_t proved = 0;
  const auto few = [&] {
    const bool is_stagnant = stagnation > patience.failures() + proved;
    return is_stagnant ? all.size() : kFew;
  };
  const auto is_proved = [&](const ParameterBox& box, std::size_t count) {
    ++boxes;
    const bool is = prover.is_proved(box);
    (is ? proved : stagnation) += is ? count : 1;
    return is;
  };
  prove_together(std::span(all), few, is_proved, [&](std::span<const LinePart> left) {
    for (const LinePart& line : left) result.lines.push_back(line.line);
  });
  if (lines.size() > kFew) patience.learn(proved > 0);
  std::ranges::sort(result.lines);
  return result;
}

}  // namespace saddle
