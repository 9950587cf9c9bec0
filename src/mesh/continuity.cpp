#include "mesh/continuity.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "eval/enclose.h"

namespace saddle {

namespace {

/// Halvings of a line until as many parts as these are too many to be narrowed down: so many of
/// them stand for all.
constexpr int kLeastHalvings = 6;
constexpr std::size_t kMostParts = 8;
/// Beside a break that is known to be there, the part of a line that is left without a proof is so
/// much of it at each step: over the rest bounds of a pole are within a factor of 16 or so.
constexpr double kBesideBreak = 1.0 / 16;

class Prover {
 public:
  Prover(const Surface& surface, double delta, int halvings)
      : enclosure_(surface.bounds, 3), delta_(delta), halvings_(halvings) {}

  /// Proves many lines at a time where boxes around them do; puts the parts of others into
  /// `result`. Changes the lines' order.
  void prove(std::span<LinePart> lines, std::vector<LinePart>& result) {
    if (lines.empty()) return;
    if (lines.size() == 1) return add_unproved(lines[0], result);
    dvec2 low = lines[0].part[0];
    dvec2 high = low;
    for (const LinePart& line : lines) {
      low = glm::min(low, glm::min(line.part[0], line.part[1]));
      high = glm::max(high, glm::max(line.part[0], line.part[1]));
    }
    if (is_proved({low, high})) return;
    const int axis = is_wider_along_u(lines, high - low) ? 0 : 1;
    const auto place = [&](const LinePart& line) {
      return line.part[0][axis] + line.part[1][axis];
    };
    const std::size_t half = lines.size() / 2;
    std::ranges::nth_element(lines, lines.begin() + static_cast<std::ptrdiff_t>(half), {}, place);
    prove(lines.first(half), result);
    prove(lines.subspan(half), result);
  }

 private:
  /// Beside the lines themselves, whose units differ.
  static bool is_wider_along_u(std::span<const LinePart> lines, const dvec2& size) {
    dvec2 sum(0);
    for (const LinePart& line : lines) sum += glm::abs(line.part[1] - line.part[0]);
    return size.x * sum.y >= size.y * sum.x;
  }

  /// Cuts a part in two; nothing if it is as short as doubles go.
  static std::optional<std::array<LinePart, 2>> cut(const LinePart& whole) {
    const auto& [line, part, broken] = whole;
    const double share = !broken ? 0.5 : *broken == 0 ? kBesideBreak : 1 - kBesideBreak;
    const dvec2 at = (1 - share) * part[0] + share * part[1];
    if (at == part[0] || at == part[1]) return std::nullopt;
    std::array<LinePart, 2> parts = {LinePart{line, {part[0], at}}, LinePart{line, {at, part[1]}}};
    if (broken) parts[*broken].broken_end = broken;
    return parts;
  }

  void add_unproved(const LinePart& line, std::vector<LinePart>& result) {
    std::vector<LinePart> level = {line};
    for (int depth = 0; !level.empty() && depth < halvings_; ++depth) {
      if (level.size() > kMostParts && depth >= kLeastHalvings) break;
      std::vector<LinePart> next;
      for (const LinePart& part : level) {
        if (is_proved(part.part)) continue;
        if (const auto parts = cut(part)) {
          next.insert(next.end(), parts->begin(), parts->end());
        } else {
          result.push_back(part);
        }
      }
      level = std::move(next);
    }
    const std::size_t step = (level.size() + kMostParts - 1) / kMostParts;
    for (std::size_t k = 0; k < level.size(); k += step) result.push_back(level[k]);
  }

  bool is_proved(const Line& box) {
    std::array<Interval, 3> position;
    enclosure_(range_between(box[0].x, box[1].x), range_between(box[0].y, box[1].y), position);
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

  Enclosure enclosure_;
  double delta_;
  int halvings_;
};

}  // namespace

std::vector<LinePart> unproved(const Surface& surface, std::vector<LinePart> lines, double delta,
                               int halvings) {
  std::vector<LinePart> result;
  Prover(surface, delta, halvings).prove(lines, result);
  std::ranges::stable_sort(result, {}, &LinePart::line);
  return result;
}

}  // namespace saddle
