#include "mesh/features/narrow_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/features/bisect_together.h"
#include "mesh/features/jumps_and_poles.h"
#include "mesh/model/tolerances.h"
#include "surface/surface_enclosure.h"

namespace saddle {

namespace {

/// Bisection of a part of a line toward its steepest place.
struct Steepest {
  LinePart part;
  Line left;
  std::array<dvec3, 2> positions;  ///< at its ends
};

/// Bisects parts toward the larger step, down to two neighbouring doubles.
void find_steepest(const Surface& surface, std::vector<Steepest>& searches, std::size_t& work) {
  std::vector<std::size_t> open = all_open(searches.size());
  const auto next = [](const Steepest& search) { return middle_of(search.left); };
  const auto is_done = [&](Steepest& search, const dvec2& middle, const dvec3& position) {
    ++work;
    const auto& [first, last] = search.positions;
    // An infinite step is not less than any.
    const bool is_first = !(glm::distance(first, position) < glm::distance(position, last));
    search.left[is_first ? 1 : 0] = middle;
    search.positions[is_first ? 1 : 0] = position;
    return has_no_middle(search.left);
  };
  bisect_together(surface, searches, open, {kAllHalvings}, next, is_done);
}

/// The rest of a part without the ways to its steepest place, if bounds prove these continuous. As
/// bounds round, there is no proof right beside a pole.
std::optional<Line> between_proofs(const Steepest& steepest, SurfaceEnclosure& enclosure,
                                   std::size_t& work) {
  const Line& whole = steepest.part.part;
  const dvec2 aside = kOfSecondOrder * (whole[1] - whole[0]);
  const Line rest = {steepest.left[0] - aside, steepest.left[1] + aside};
  const double length = length_of(whole);
  const bool is_inside =
      glm::distance(whole[0], rest[1]) < length && glm::distance(rest[0], whole[1]) < length;
  const auto is_continuous = [&](const dvec2& from, const dvec2& to) {
    ++work;
    return are_continuous(enclosure.enclose({from, to}));
  };
  const bool is_proved =
      is_inside && is_continuous(whole[0], rest[0]) && is_continuous(rest[1], whole[1]);
  return is_proved ? std::optional(rest) : std::nullopt;
}

}  // namespace

std::vector<LinePart> narrowed(const Surface& surface, SurfaceEnclosure& enclosure,
                               std::span<const Line> lines, std::span<const LinePart> parts,
                               double delta, std::size_t& work) {
  std::vector<dvec2> uv;
  for (const LinePart& part : parts) uv.insert(uv.end(), part.part.begin(), part.part.end());
  const std::vector<dvec3> positions = evaluate_positions(surface, uv, 1);
  work += uv.size();
  const auto is_bounded = [&](const Line& part) {
    ++work;
    return std::ranges::all_of(enclosure.enclose({part[0], part[1]}),
                               [](const Interval& a) { return std::isfinite(a.high - a.low); });
  };
  std::vector<LinePart> done;
  std::vector<Steepest> searches;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const LinePart& part = parts[k];
    const bool is_step = glm::distance(positions[2 * k], positions[2 * k + 1]) > delta;
    const bool is_short = length_of(part.part) <= kSame * length_of(lines[part.line]);
    // So few doubles are left that between_proofs() would go beyond the part.
    const bool is_narrow = least_share(part.part) >= kOfSecondOrder;
    if (is_short && !is_narrow && !(is_step && is_bounded(part.part))) {
      searches.push_back({part, part.part, {positions[2 * k], positions[2 * k + 1]}});
    } else {
      done.push_back(part);
    }
  }
  find_steepest(surface, searches, work);
  std::vector<LinePart> open;
  for (const Steepest& search : searches) {
    const auto rest =
        search.part.broken_end ? std::nullopt : between_proofs(search, enclosure, work);
    if (rest) {
      done.push_back({search.part.line, *rest});
    } else {
      open.push_back(search.part);
    }
  }
  open = unproved(enclosure, std::move(open), delta, work);
  done.insert(done.end(), open.begin(), open.end());
  std::ranges::stable_sort(done, {}, &LinePart::line);
  return done;
}

}  // namespace saddle
