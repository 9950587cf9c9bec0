#include "mesh/features/jumps_and_poles.h"

#include <array>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "mesh/features/approach.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

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
  return bisect_positions(surface, gaps, {delta}, threads, work);
}

/// The last places at which the surface is defined on the ways from the ends of a gap to a place in
/// it that has no value.
Line rims_beside(const Surface& surface, const Line& ends, const dvec2& place, unsigned threads) {
  const std::array<Line, 2> ways = {Line{ends[0], place}, Line{ends[1], place}};
  const std::vector<dvec2> last = last_defined(surface, ways, kAllHalvings, threads);
  return {last[0], last[1]};
}

/// The kind of a gap without a pole that may have no value in the middle. It is a pole if values
/// there exceed the largest double; a jump if what is undefined is made of rounding, with a sheet
/// on either side, as where a jump meets the rim of a hole. The ends are then moved to the last
/// values.
Discontinuity kind_of_gap(const Surface& surface, double delta, unsigned threads, Line& ends) {
  const dvec2 middle = near_middle(ends);
  const dvec3 value = evaluate_positions(surface, std::array{middle}, 1)[0];
  if (is_finite(value)) return Discontinuity::None;
  const Line rims = rims_beside(surface, ends, middle, threads);
  if (!glm::any(glm::isnan(value))) {
    ends = rims;
    return Discontinuity::Pole;
  }
  const double width = length_in_ranges(rims, box_of(surface.domain).size());
  // One place without a value, as that of sin(1/(u+v)), has waves beside it.
  if (width < kSame || width > kBesidePole.back()) return Discontinuity::None;
  const std::vector<dvec3> at = evaluate_positions(surface, rims, 1);
  if (!(glm::distance(at[0], at[1]) > delta)) return Discontinuity::None;
  ends = rims;
  return Discontinuity::Jump;
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

/// Corrects kinds by diverge().
void verify(const Surface& surface, std::span<const Line> lines, double delta, unsigned threads,
            std::span<LocatedDiscontinuity> found) {
  const std::vector<bool> far = diverge_beside(surface, lines, found, delta, threads);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (far[k]) found[k].kind = Discontinuity::Pole;
    if (far[k] || found[k].kind != Discontinuity::Pole) continue;
    Line& ends = found[k].ends;
    found[k].kind = kind_of_gap(surface, delta, threads, ends);
    if (found[k].kind != Discontinuity::None) continue;
    const dvec2 middle = near_middle(ends);
    const bool is_gap =
        (middle == ends[0] || middle == ends[1]) && length_of(ends) <= kSame * length_of(lines[k]);
    if (is_gap) found[k].kind = Discontinuity::Jump;
  }
}

}  // namespace

double length_of(const Line& line) {
  return glm::distance(line[0], line[1]);
}

std::vector<LocatedDiscontinuity> follow_lines(const Surface& surface, std::span<const Line> lines,
                                               double delta, unsigned threads, std::size_t& work) {
  std::vector<LocatedDiscontinuity> found =
      follow_positions(surface, lines, lines, delta, threads, work);
  verify(surface, lines, delta, threads, found);
  return found;
}

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
    if (!is_pole && found[i].kind == Discontinuity::Pole)
      found[i].kind = kind_of_gap(surface, delta, threads, found[i].ends);
  }
  return found;
}

}  // namespace saddle
