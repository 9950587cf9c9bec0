#include "mesh/features/approach.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "mesh/features/way_out.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "surface/normal.h"
#include "surface/parameter_box.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Halvings, after kFirstHalvings, that leave the parts that end_in_gaps() looks at, of a line on
/// which bounds prove something by then. On others they are too wide for any part.
constexpr int kMoreHalvingsToGap = 5;
/// Lines through more gaps lead across waves. Their first gap is the rim of one, which a mesh would
/// follow without an end.
constexpr std::size_t kMostGaps = 2;

/// A factor for kApproach on a short line: its nearest place is then 256 doubles from the end.
double widening(const Line& line) {
  constexpr double kDigits = 256 * std::numeric_limits<double>::epsilon();
  const dvec2 way = glm::abs(line[1] - line[0]);
  const dvec2 end = glm::abs(line[0]);
  const double length = std::max(way.x, way.y);
  const double place = way.x > way.y ? end.x : end.y;
  if (!(length > 0)) return 1;
  const double most = 0.5 / kApproach.front();  // the farthest place is the middle of the line
  return std::clamp(kDigits * place / (kApproach.back() * length), 1.0, most);
}

/// The place at a share of a line from its first end, which diverge() evaluates.
dvec2 approach(const Line& line, double share) {
  return line[0] + widening(line) * share * (line[1] - line[0]);
}

/// Whether positions on the way to a place go on as they do beside a pole: no move is shorter, in
/// its direction, than kShrinks of the one before.
bool go_on(std::span<const dvec3> positions) {
  double size = 0;  // squares of what is near the largest of doubles would overflow
  for (const dvec3& position : positions) size = std::max(size, safe_length(position));
  dvec3 before(0);
  for (std::size_t i = 1; i < positions.size(); ++i) {
    const dvec3 way = positions[i] / size - positions[i - 1] / size;
    if (!(glm::dot(way, before) >= kShrinks * glm::dot(before, before))) return false;
    before = way;
  }
  return true;
}

/// Whether they go on by more than `delta` each time. The last may be that of ln(0).
bool go_on_by(std::span<const dvec3> positions, double delta) {
  if (!is_finite(positions.back())) positions = positions.first(positions.size() - 1);
  for (std::size_t i = 1; i < positions.size(); ++i) {
    if (!(safe_length(positions[i] - positions[i - 1]) > delta)) return false;
  }
  return go_on(positions);
}

/// Whether bounds of the surface around a line's first end are finite. The box reaches beyond the
/// end as far as before it, a share of the line, so that it contains a pole that rounding
/// misplaces.
bool is_bounded(SurfaceEnclosure& enclosure, const Line& line, double share) {
  const dvec2 reach = share * (line[1] - line[0]);
  return std::ranges::all_of(enclosure.enclose({line[0] - reach, line[0] + reach}),
                             [](const Interval& a) { return std::isfinite(a.high - a.low); });
}

/// Adds to the lines that diverge those on which the surface does until rounding ends it.
void look_beside_poles(const Surface& surface, std::span<const Line> lines, double delta,
                       unsigned threads, SurfaceEnclosure& enclosure, std::vector<bool>& diverges) {
  const dvec2 range = box_of(surface.domain).size();
  const auto share = [&](const Line& line, double of_range) {
    return of_range / length_in_ranges(line, range);
  };
  std::vector<std::size_t> numbers;
  std::vector<dvec2> places;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (diverges[k] || !(share(lines[k], kBesidePole.front()) <= 1)) continue;
    numbers.push_back(k);
    for (const double at : kBesidePole)
      places.push_back(glm::mix(lines[k][0], lines[k][1], share(lines[k], at)));
  }
  if (numbers.empty()) return;
  const std::vector<dvec3> found = evaluate_positions(surface, places, threads);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t k = numbers[i];
    const auto along = std::span(found).subspan(i * kBesidePole.size(), kBesidePole.size());
    diverges[k] = go_on_by(along, delta) &&
                  !is_bounded(enclosure, lines[k], share(lines[k], kBesidePole.back()));
  }
}

}  // namespace

std::vector<bool> diverge(const Surface& surface, std::span<const Line> lines, double delta,
                          unsigned threads) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) {
    for (const double share : kApproach) uv.push_back(approach(line, share));
  }
  const std::vector<dvec3> found = evaluate_positions(surface, uv, threads);
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  std::vector<bool> result;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto along = std::span(found).subspan(k * kApproach.size(), kApproach.size());
    // Each step is 16 times as near, until doubles run out beside 0.
    const double steps_left = kHalvingsToLeast / 4.0;
    const double last_move = safe_length(along.back() - along[along.size() - 2]);
    result.push_back(steps_left * last_move > delta && go_on(along) &&
                     !is_bounded(enclosure, lines[k], widening(lines[k]) * kApproach.front()));
  }
  look_beside_poles(surface, lines, delta, threads, enclosure, result);
  return result;
}

std::array<dvec2, 2> nearest_approaches(const Line& line) {
  return {approach(line, kApproach[kApproach.size() - 2]), approach(line, kApproach.back())};
}

std::vector<dvec2> last_defined(const Surface& surface, std::span<const Line> lines, int halvings,
                                unsigned threads, const std::optional<Bounds>& box) {
  std::vector<WayOut> ways;
  for (const Line& line : lines) ways.emplace_back(line, halvings, box);
  return leave(surface, ways, threads);
}

namespace {

/// The parts of lines on which it is not proved that the surface is defined: all of a line on whose
/// parts bounds prove nothing, and a few for the rest.
std::vector<LinePart> maybe_undefined(SurfaceEnclosure& enclosure, std::vector<LinePart> lines,
                                      std::size_t& boxes) {
  std::vector<LinePart> open;
  std::vector<LinePart> halved =
      unproved(enclosure, std::move(lines), kInfinity, boxes, kFirstHalvings);
  std::vector<LinePart> some;
  for (auto part = halved.begin(); part != halved.end();) {
    const auto end = std::find_if(part, halved.end(),
                                  [&](const LinePart& other) { return other.line != part->line; });
    auto& to = end - part == 1 << kFirstHalvings ? open : some;
    to.insert(to.end(), part, end);
    part = end;
  }
  some = unproved(enclosure, std::move(some), kInfinity, boxes, kMoreHalvingsToGap);
  open.insert(open.end(), some.begin(), some.end());
  std::ranges::stable_sort(open, {}, &LinePart::line);
  return open;
}

}  // namespace

void end_in_gaps(const Surface& surface, std::span<Line> lines, unsigned threads,
                 const std::optional<Bounds>& box, std::size_t& work) {
  SurfaceEnclosure enclosure(surface, Bounded::Position);
  std::vector<LinePart> open;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (least_defined(enclosure.enclose({lines[k][0], lines[k][1]})) != Defined::Yes)
      open.push_back({k, lines[k]});
  }
  const auto are_seen = [&](std::span<const dvec2> places) {
    work += places.size();
    std::vector<bool> result;
    for (const dvec3& p : evaluate_positions(surface, places, threads))
      result.push_back(is_seen(box, p));
    return result;
  };
  std::vector<dvec2> places(open.size());
  std::ranges::transform(open, places.begin(), [](const LinePart& line) { return line.part[1]; });
  const std::vector<bool> reaches_sheet = are_seen(places);
  std::size_t next = 0;
  std::erase_if(open, [&](const LinePart&) { return !reaches_sheet[next++]; });
  open = maybe_undefined(enclosure, std::move(open), work);
  places.clear();
  for (const LinePart& part : open) {
    for (const double share : kAllAlongLine)
      places.push_back(glm::mix(part.part[0], part.part[1], share));
  }
  const std::vector<bool> seen = are_seen(places);
  std::size_t i = 0;
  while (i < places.size()) {
    const std::size_t number = open[i / kAllAlongLine.size()].line;
    std::optional<dvec2> first;
    std::size_t gaps = 0;
    bool is_in_gap = false;
    for (; i < places.size() && open[i / kAllAlongLine.size()].line == number; ++i) {
      if (!seen[i] && !first) first = places[i];
      if (!seen[i] && !is_in_gap) ++gaps;
      is_in_gap = !seen[i];
    }
    if (first && gaps <= kMostGaps) lines[number][1] = *first;
  }
}

}  // namespace saddle
