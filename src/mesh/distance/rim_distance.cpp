// The distances of rims, where the surface is undefined beyond, from their chords.
#include "mesh/distance/boundary_distance.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/features/approach.h"
#include "mesh/features/removable.h"
#include "mesh/features/way_out.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/segment.h"
#include "mesh/model/tolerances.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// Where on its chord an edge may have a corner, by its distances across kAlongLine. Up to a corner
/// they grow as from an end of the chord: that across the middle is twice the one before it, and on
/// an arc 4/3 of it.
std::vector<double> corners_of_edge(const std::array<double, kAlongLine.size()>& distances) {
  const double middle = distances[1];
  const auto& [near, far] = std::minmax(distances[0], distances[2]);
  if (!(middle >= 0.5 * (4.0 / 3 + 2) * near)) return {};
  // The lines from both ends meet there, or it is beyond the last place.
  const double meeting = 4 * far / (2 * middle + 4 * far);
  std::vector<double> shares = {meeting};
  if (meeting >= kAlongLine.back() * (1 - kNearly)) shares = {0.8125, 0.875, 0.9375};
  if (distances[0] > distances[2]) {
    for (double& share : shares) share = 1 - share;
  }
  return shares;
}

}  // namespace

/// Where the surface, or its part in the clip box, ends on ways across chords.
std::vector<dvec2> BoundaryDistance::ends_of(std::span<const Line> ways) const {
  std::vector<WayOut> out;
  for (std::size_t k = 0; k < ways.size(); ++k)
    out.emplace_back(ways[k], chords_[k].is_at_face ? kHalvingsToLeast : kHalvingsToEdge, clip_);
  std::vector<dvec2> ends = leave(surface_, out, threads_);
  follow_outside(ways, ends);
  return ends;
}

/// Moves the ends of ways that are still defined at the border of their leaf to the boundary in the
/// next leaf, if it is there.
void BoundaryDistance::follow_outside(std::span<const Line> ways, std::vector<dvec2>& ends) const {
  std::vector<std::size_t> open;
  std::vector<Line> outside;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const EdgeChord& chord = chords_[k];
    if (!chord.outside || ways[k][1] != chord.beyond || !is_at_end(ends[k], ways[k])) continue;
    open.push_back(k);
    outside.push_back({chord.beyond, *chord.outside});
  }
  const std::vector<dvec2> last = last_defined(surface_, outside, kHalvingsToEdge, threads_, clip_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!is_at_end(last[i], outside[i])) ends[open[i]] = last[i];
  }
}

/// Whether places are seen.
std::vector<bool> BoundaryDistance::are_seen(std::span<const dvec2> uv) {
  std::vector<bool> seen;
  for (const dvec3& p : evaluate_positions(surface_, uv, threads_))
    seen.push_back(is_seen(clip_, p));
  evaluations_ += uv.size();
  return seen;
}

/// The first place on each line that is seen, of three after its first end.
std::vector<std::optional<dvec2>> BoundaryDistance::first_seen(std::span<const Line> lines) {
  std::vector<dvec2> uv;
  for (const Line& line : lines) {
    for (const double share : kAlongLine) uv.push_back(glm::mix(line[0], line[1], share));
  }
  const std::vector<bool> are = are_seen(uv);
  std::vector<std::optional<dvec2>> seen(lines.size());
  for (std::size_t i = uv.size(); i-- > 0;) {
    if (are[i]) seen[i / kAlongLine.size()] = uv[i];
  }
  return seen;
}

/// Ways across chords that cross the boundary: outward if the surface is seen at the chord's
/// middle, else from inside to the middle. Where a rim has a corner, the leaf's border straight
/// inside may be in the gap across from it, and all of the way, too: then the way is aslant, from
/// above an end of the chord.
std::vector<Line> BoundaryDistance::ways_to_boundary(std::span<const SurfacePoint> at_middle) {
  std::vector<Line> ways;
  std::vector<std::size_t> covered;  // chords whose middle is not seen
  std::vector<dvec2> across;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const EdgeChord& chord = chords_[k];
    const bool is_covered = !is_seen(clip_, at_middle[k].position);
    ways.push_back(is_covered ? Line{chord.across, chord.middle}
                              : Line{chord.middle, chord.beyond});
    if (!is_covered) continue;
    covered.push_back(k);
    across.push_back(chord.across);
  }
  const std::vector<bool> is_inside = are_seen(across);
  std::vector<std::size_t> open;
  std::vector<Line> lines;  // straight inside, and to above both ends, for each
  for (std::size_t i = 0; i < covered.size(); ++i) {
    const EdgeChord& chord = chords_[covered[i]];
    ways[covered[i]][0] = is_inside[i] ? chord.across : chord.opposite;
    if (is_inside[i] || chord.across == chord.middle) continue;
    open.push_back(covered[i]);
    lines.push_back({chord.middle, chord.across});
    for (const double end : {0.0, 1.0}) {
      const dvec2 above = on_chord(chord.ends, end) + chord.across - chord.middle;
      lines.push_back({chord.middle, nearest_in(box_of(surface_.domain), above)});
    }
  }
  const auto seen = first_seen(lines);
  for (std::size_t i = 0; i < open.size(); ++i) {
    const auto of = std::span(seen).subspan(3 * i, 3);
    const auto found =
        std::ranges::find_if(of, [](const auto& place) { return place.has_value(); });
    EdgeChord& chord = chords_[open[i]];
    if (found != of.end() && found != of.begin())
      chord.aslant_from = chord.ends[static_cast<std::size_t>(found - of.begin()) - 1];
    if (found != of.end()) ways[open[i]][0] = **found;
  }
  return ways;
}

/// The surface's boundary may be on either side of its chord: the mesh covers too much or too
/// little. All that is between chord and boundary is an error.
void BoundaryDistance::measure_chords(std::vector<LeafDistance>& found) {
  const std::vector<RimDistance> of_middles = measure_places(found);
  std::vector<EdgeChord> beside;
  std::vector<double> middles;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    // A corner is up to twice as far from the chord as the edge across the middle. Rims that
    // rounding moves have none that can be told.
    const double share = of_middles[k].distance / chords_[k].allowed;
    const bool may_be_corner = share > 0.5 && share <= 1 && !of_middles[k].is_rounded;
    if (!may_be_corner || chords_[k].is_outward || chords_[k].is_at_face) continue;
    for (const double at : {kAlongLine.front(), kAlongLine.back()})
      beside.push_back(beside_middle(chords_[k], at));
    middles.push_back(of_middles[k].distance);
  }
  chords_ = std::move(beside);
  const std::vector<RimDistance> ends = measure_places(found);
  std::vector<EdgeChord> corners;
  for (std::size_t k = 0; k < middles.size(); ++k) {
    for (const double share :
         corners_of_edge({ends[2 * k].distance, middles[k], ends[2 * k + 1].distance}))
      corners.push_back(beside_middle(chords_[2 * k], share));
  }
  chords_ = std::move(corners);
  measure_places(found);
}

/// The distance of the mesh's point at a chord's place from the arm of a corner that goes from an
/// end of the chord to a place on the rim.
double BoundaryDistance::distance_aslant(const EdgeChord& chord, const dvec3& on_rim) const {
  const auto& [a, b] = chord.ends;
  const dvec2 along = grid_.mesh.uv[b] - grid_.mesh.uv[a];
  const double share = glm::dot(chord.middle - grid_.mesh.uv[a], along) / glm::dot(along, along);
  const auto& position = grid_.mesh.position;
  return distance_from_segment(position[*chord.aslant_from], on_rim,
                               glm::mix(position[a], position[b], share));
}

/// The same chord at another place of it, with ways as long as those at its middle.
BoundaryDistance::EdgeChord BoundaryDistance::beside_middle(EdgeChord chord, double share) const {
  const ParameterBox domain = box_of(surface_.domain);
  const dvec2 shift = on_chord(chord.ends, share) - chord.middle;
  for (dvec2* const place : {&chord.middle, &chord.across, &chord.beyond})
    *place = nearest_in(domain, *place + shift);
  chord.outside.reset();
  chord.aslant_from.reset();
  chord.is_beside_middle = true;
  return chord;
}

/// Returns the distances of the edge across each place on a chord.
std::vector<BoundaryDistance::RimDistance> BoundaryDistance::measure_places(
    std::vector<LeafDistance>& found) {
  std::vector<RimDistance> distances(chords_.size());
  if (chords_.empty()) return distances;
  std::vector<dvec2> middles(chords_.size());
  std::ranges::transform(chords_, middles.begin(), &EdgeChord::middle);
  const std::vector<SurfacePoint> at_middle = evaluate(surface_, middles, threads_);
  std::vector<Line> ways = ways_to_boundary(at_middle);
  end_in_gaps(surface_, ways, threads_, clip_, looks_);
  const std::vector<dvec2> boundary = ends_of(ways);
  const std::vector<SurfacePoint> at_boundary = evaluate(surface_, boundary, threads_);
  evaluations_ += chords_.size() * (2 + kHalvingsToEdge);
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const EdgeChord& chord = chords_[k];
    const bool is_seen_at_middle = is_seen(clip_, at_middle[k].position);
    if (chord.is_outward && !is_seen_at_middle) continue;
    distances[k].is_rounded =
        !(moved_by_last_digit(at_boundary[k], boundary[k]) <= kUnnoticed * chord.allowed);
    distances[k].distance =
        chord.aslant_from ? distance_aslant(chord, at_boundary[k].position)
                          : distance_from_edge(chord, chord.triangles, boundary[k], at_boundary[k]);
    if (chord.is_beside_middle && distances[k].is_rounded) continue;
    found.push_back({chord.leaf, distances[k].distance});
    // A part of the surface beyond the chord may be near triangles of other leaves.
    if (is_beyond(chord, boundary[k])) found.back().uv = boundary[k];
    if (!is_seen_at_middle) continue;
    found.push_back(
        {chord.leaf, distance_from(grid_, chord.triangles, chord.middle, at_middle[k].position)});
    found.back().uv = chord.middle;
  }
  measure_beyond_box(at_middle, found);
  return distances;
}

/// Chords outside of the clip box may have an edge in it: that of sqrt(v)/u^2 is z=0 to the pole.
void BoundaryDistance::measure_beyond_box(std::span<const SurfacePoint> at_middle,
                                          std::vector<LeafDistance>& found) {
  std::vector<std::size_t> numbers;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const dvec3& position = at_middle[k].position;
    if (chords_[k].is_outward && is_finite(position) && !is_seen(clip_, position))
      numbers.push_back(k);
  }
  const auto ends_after = [&](int halvings) {
    std::vector<Line> ways;
    ways.reserve(numbers.size());
    for (const std::size_t k : numbers) ways.push_back({chords_[k].middle, chords_[k].beyond});
    const std::vector<dvec2> uv = last_defined(surface_, ways, halvings, threads_);
    evaluations_ += ways.size() * (1 + static_cast<std::size_t>(halvings));
    return std::pair(uv, evaluate(surface_, uv, threads_));
  };
  // A way to infinity leads away from the box.
  std::size_t next = 0;
  const std::vector<SurfacePoint> near = ends_after(kHalvingsToSight).second;
  std::erase_if(numbers, [&](std::size_t k) {
    const double before = distance_beyond(*clip_, at_middle[k].position);
    return distance_beyond(*clip_, near[next++].position) > before;
  });
  const auto [uv, points] = ends_after(kHalvingsToEdge);
  for (std::size_t i = 0; i < uv.size(); ++i) {
    if (!is_seen(clip_, points[i].position)) continue;
    const EdgeChord& chord = chords_[numbers[i]];
    found.push_back({chord.leaf, distance_from_edge(chord, chord.triangles, uv[i], points[i])});
    found.back().uv = uv[i];
  }
}

}  // namespace saddle
