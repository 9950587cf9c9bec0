// The part of BoundaryDistance that measures where sheets end beside jumps and cliffs.
#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/distance/boundary_distance.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/distance/sheet_view.h"
#include "mesh/features/cliffs.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Lines of jumps end where they are smaller than a quarter of the tolerance: kUnnoticed. Along
/// slight ones sheets end at jumps of half of that, and other jumps of up to a tolerance do not
/// count.
constexpr double kSlight = 2;

/// The largest distance of an edge from its chord, by its heights on the ways across. `middle`: the
/// end of the middle way.
double largest_distance(std::span<const Height> heights, const std::optional<SheetEnd>& middle,
                        double allowed) {
  // The middle way meets the corner of two lines of constant u and v. Where these cross, it may go
  // on in a sheet of the same height, as that of sign(u)*sign(v).
  const bool goes_on = middle && middle->kind == SheetEnd::Kind::Open;
  if (heights.size() == 2 && goes_on) return height_of_roof(heights[0], heights[1]);
  if (heights.size() < kAlongLine.size()) return 0;
  // Where the sheet's edge leaps to the end of the chord, as at the end of the jump of atan2(v, u),
  // distances grow up to there.
  const auto at_end = [&](std::size_t k) { return 2 * heights[k].distance - heights[1].distance; };
  const double predicted =
      std::max({predicted_distance({heights[0], heights[1], heights[2]}), at_end(0), at_end(2)});
  const double farthest = std::ranges::max(heights, {}, &Height::distance).distance;
  return supported_distance(predicted, farthest, allowed);
}

/// The distance of a place in a box from the nearest face.
double distance_within(const Bounds& box, const dvec3& place) {
  const dvec3 left = glm::min(place - box.low, box.high - place);
  return std::min({left.x, left.y, left.z});
}

}  // namespace

/// Adds a leaf with a jump, unless it leads to a pole.
void BoundaryDistance::add_at_jump(const Leaf& leaf, std::size_t number,
                                   std::span<const Triangle> triangles, double allowed) {
  if (leaf.state.leads_to_pole() || has_cut(FeatureKind::Pole, leaf, tree_)) return;
  delta_ = std::min(delta_, allowed);
  add_flat_sheets(leaf, number, allowed);
  add_edges_on_sides(leaf, number, allowed);
  if (triangles.empty()) return add_omitted(leaf, number, allowed, true);
  if (close_jumps_.add(leaf, number, triangles, allowed)) return;
  const std::size_t first = jumps_.size();
  add_chords(leaf, number, triangles, FeatureKind::Jump, allowed);
  const bool is_slight = has_slight_jump(leaf, allowed);
  for (EdgeChord& chord : std::span(jumps_).subspan(first)) chord.is_at_slight_jump = is_slight;
}

/// Adds the sheets that reach into a leaf across one side alone. They have no triangles there, as
/// their vertices are on that side.
void BoundaryDistance::add_flat_sheets(const Leaf& leaf, std::size_t number, double allowed) {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t corner) { return (grid_.mesh.uv[corner] - low) / size; };
  for (const Polygon& sheet : sub_polygons(leaf, tree_)) {
    if (!is_flat(sheet)) continue;
    const Chord ends = {sheet.front().corner, sheet.back().corner};
    const dvec2 along = place(ends[1]) - place(ends[0]);
    std::vector<dvec2> starts;
    starts.reserve(kAlongLine.size());
    for (const double share : kAlongLine) starts.push_back(on_chord(ends, share));
    const std::vector<SurfacePoint> points = evaluate(surface_, starts, threads_);
    evaluations_ += points.size();
    // On a jump along the side the surface is on another sheet.
    if (std::ranges::any_of(points, [&](const SurfacePoint& point) {
          return !(distance_from_chord(grid_, ends, point.position) <= allowed);
        }))
      continue;
    for (const dvec2& start : starts) {
      // Counter-clockwise, the leaf is to the left.
      const dvec2 beyond = low + size * border_of_square((start - low) / size, {-along.y, along.x});
      jumps_.push_back(
          {number, allowed, {}, {}, ends, start, start, start, beyond, std::nullopt, false});
    }
  }
}

/// Measures the edges of sheets that end at the very side of a leaf, from outside. The leaf beside
/// this one, which has their triangles, takes the side for one in the middle of a sheet.
void BoundaryDistance::add_edges_on_sides(const Leaf& leaf, std::size_t number, double allowed) {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const ParameterBox domain = box_of(surface_.domain);
  for (const Chord& side : sides_along_jumps(leaf, tree_)) {
    const dvec2 along = glm::normalize((grid_.mesh.uv[side[1]] - grid_.mesh.uv[side[0]]) / size);
    // Counter-clockwise, the leaf is to the left.
    const dvec2 outward = kNearly * size * dvec2(along.y, -along.x);
    const dvec2 outside = on_chord(side, kMiddleOfLine[0]) + outward;
    if (nearest_in(domain, outside) != outside) continue;
    std::vector<dvec2> uv;
    for (const double share : kAlongLine) {
      uv.push_back(on_chord(side, share));
      uv.push_back(uv.back() + outward);
    }
    const std::vector<dvec3> at = evaluate_positions(surface_, uv, threads_);
    evaluations_ += uv.size();
    for (std::size_t k = 0; k < at.size(); k += 2) {
      // A line of its own, as that of sign(v) at v=0, is the edge of no sheet.
      if (!(glm::distance(at[k], at[k + 1]) <= allowed) || !is_seen(clip_, at[k])) continue;
      on_sides_.push_back({number, distance_from_chord(grid_, side, at[k]), true, uv[k]});
    }
  }
}

/// Where sheets end on the ways across chords: at jumps, or at the foot or head of a cliff.
std::vector<std::optional<SheetEnd>> BoundaryDistance::ends_of_sheets() {
  std::vector<std::size_t> at_jumps;
  std::vector<std::size_t> at_slight_jumps;
  std::vector<std::size_t> at_cliffs;
  for (std::size_t k = 0; k < jumps_.size(); ++k) {
    const EdgeChord& chord = jumps_[k];
    (chord.is_at_cliff         ? at_cliffs
     : chord.is_at_slight_jump ? at_slight_jumps
                               : at_jumps)
        .push_back(k);
  }
  std::vector<std::optional<SheetEnd>> ends(jumps_.size());
  if (!at_jumps.empty()) end_at_jumps(at_jumps, delta_, ends);
  if (!at_slight_jumps.empty()) end_at_jumps(at_slight_jumps, 0.5 * kUnnoticed * delta_, ends);
  if (!at_cliffs.empty()) end_at_cliffs(at_cliffs, ends);
  check_at_faces(ends);
  return ends;
}

/// Drops the ends of ways across chords that may leave the clip box, where sheets end on its faces,
/// and of ways that begin beyond it: beside a pole, steep parts would be taken for gaps. They hide
/// gaps, too: others are looked for before those that were found. A sheet that ends far from the
/// faces, or comes no nearer to them, ends at a jump to what is clipped.
void BoundaryDistance::check_at_faces(std::vector<std::optional<SheetEnd>>& ends) {
  std::vector<std::size_t> outward;
  std::vector<dvec2> places;  // where ways begin and end
  for (std::size_t k = 0; k < jumps_.size(); ++k) {
    if (!jumps_[k].is_outward) continue;
    outward.push_back(k);
    places.push_back(jumps_[k].opposite);
    places.push_back(ends[k] ? ends[k]->uv : jumps_[k].opposite);
  }
  if (outward.empty()) return;
  const std::vector<dvec3> positions = evaluate_positions(surface_, places, threads_);
  evaluations_ += places.size();
  for (std::size_t i = 0; i < outward.size(); ++i) {
    std::optional<SheetEnd>& end = ends[outward[i]];
    const dvec3& first = positions[2 * i];
    if (!is_seen(clip_, first)) {
      end.reset();
    } else if (end && end->kind == SheetEnd::Kind::Boundary) {
      const double left = distance_within(*clip_, positions[2 * i + 1]);
      const bool ends_on_face =
          left <= jumps_[outward[i]].allowed && left < distance_within(*clip_, first);
      if (!ends_on_face) end->kind = SheetEnd::Kind::Jump;
      if (ends_on_face) end.reset();
    }
  }
  const auto is_at_jump = [&](std::size_t k) {
    return ends[k] && ends[k]->kind == SheetEnd::Kind::Jump;
  };
  for (int round = 0; round < kHalvingsToNearly; ++round) {
    std::erase_if(outward, [&](std::size_t k) { return !is_at_jump(k); });
    if (outward.empty()) return;
    std::vector<Line> ways;
    ways.reserve(outward.size());
    for (const std::size_t k : outward) ways.push_back({jumps_[k].opposite, ends[k]->uv});
    const auto before =
        sheet_ends(surface_, ways, {delta_, kHalvingsToNearly, clip_}, threads_, looks_);
    std::vector<std::size_t> moved;
    for (std::size_t i = 0; i < outward.size(); ++i) {
      if (!before[i] || before[i]->kind != SheetEnd::Kind::Jump) continue;
      ends[outward[i]] = before[i];
      moved.push_back(outward[i]);
    }
    outward = std::move(moved);
  }
}

/// Whether a jump on the sides of a leaf is so small that its line may end in the leaf.
bool BoundaryDistance::has_slight_jump(const Leaf& leaf, double allowed) const {
  const auto& position = grid_.mesh.position;
  bool has = false;
  for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree_.edges().feature(a, b);
    if (!feature || feature->kind != FeatureKind::Jump) return;
    feature->for_jumps(a, [&](std::uint32_t before, std::uint32_t after) {
      has = has || glm::distance(position[before], position[after]) < kSlight * allowed;
    });
  });
  return has;
}

/// Follows ways that leave their leaf where the next one has nothing of the sheet. A gap of less
/// than `least` is no jump.
void BoundaryDistance::end_at_jumps(std::span<const std::size_t> numbers, double least,
                                    std::vector<std::optional<SheetEnd>>& ends) {
  std::vector<Line> ways;
  for (const std::size_t k : numbers) ways.push_back({jumps_[k].opposite, jumps_[k].beyond});
  const SheetEndSearch search{least, kHalvingsToNearly, clip_};
  const auto found = sheet_ends(surface_, ways, search, threads_, looks_);
  std::vector<std::size_t> open;
  std::vector<Line> outside;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::size_t k = numbers[i];
    ends[k] = found[i];
    if (!ends[k] || ends[k]->kind != SheetEnd::Kind::Open || !jumps_[k].outside) continue;
    open.push_back(k);
    outside.push_back({jumps_[k].beyond, *jumps_[k].outside});
  }
  const auto more = sheet_ends(surface_, outside, search, threads_, looks_);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (more[i] && more[i]->kind == SheetEnd::Kind::Jump) ends[open[i]] = more[i];
  }
}

/// A way without a cliff says nothing of its chord.
void BoundaryDistance::end_at_cliffs(std::span<const std::size_t> numbers,
                                     std::vector<std::optional<SheetEnd>>& ends) {
  std::vector<Line> ways;
  for (const std::size_t k : numbers)
    ways.push_back({jumps_[k].opposite, jumps_[k].outside.value_or(jumps_[k].beyond)});
  const auto cliffs = find_cliffs(surface_, ways, delta_, threads_, looks_);
  for (std::size_t i = 0; i < cliffs.size(); ++i) {
    if (!cliffs[i].empty()) ends[numbers[i]] = SheetEnd{cliffs[i].front(), SheetEnd::Kind::Jump};
  }
}

/// Whether a place of a sheet just before a chord, through which the sheet goes on, is measured.
bool BoundaryDistance::counts_before(const EdgeChord& chord, const dvec3& place) const {
  return !chord.triangles.empty() && is_seen(clip_, place);
}

/// Whether a sheet's last place is at most two steps of the search before its chord, and yet
/// farther from it than half of what is allowed.
bool BoundaryDistance::is_steep_end(const EdgeChord& chord, const SheetEnd& end,
                                    const dvec3& position) const {
  if (end.kind != SheetEnd::Kind::Jump || is_beyond(chord, end.uv)) return false;
  const double left = glm::distance(end.uv, chord.middle);
  if (left > 2 * kNearly * glm::distance(chord.opposite, chord.beyond)) return false;
  return distance_from_chord(grid_, chord.ends, position) > chord.allowed / 2;
}

/// The surface where sheets end, or at the starts of ways without an end. Looks nearer at the ends
/// of steep sheets: u^0.25 reaches a hundredth on a millionth of the way.
std::vector<SurfacePoint> BoundaryDistance::evaluate_ends(
    std::vector<std::optional<SheetEnd>>& ends) {
  std::vector<dvec2> uv;
  uv.reserve(ends.size());
  for (std::size_t k = 0; k < ends.size(); ++k)
    uv.push_back(ends[k] ? ends[k]->uv : jumps_[k].opposite);
  std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += uv.size();
  bool has_moved = true;
  // Parts of the ways, which hold their ends.
  for (double part = 2 * kNearly; has_moved; part *= 2 * kNearly) {
    has_moved = false;
    std::vector<std::size_t> steep;
    std::vector<Line> ways;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      if (!ends[k] || !is_steep_end(jumps_[k], *ends[k], points[k].position)) continue;
      steep.push_back(k);
      ways.push_back({ends[k]->uv, ends[k]->uv + part * (jumps_[k].beyond - jumps_[k].opposite)});
    }
    if (steep.empty()) break;
    const auto nearer =
        sheet_ends(surface_, ways, {delta_, kHalvingsToNearly, clip_}, threads_, looks_);
    std::vector<dvec2> nearer_uv;
    nearer_uv.reserve(steep.size());
    for (std::size_t i = 0; i < steep.size(); ++i) {
      SheetEnd& end = *ends[steep[i]];
      const bool is_jump = nearer[i] && nearer[i]->kind == SheetEnd::Kind::Jump;
      has_moved = has_moved || (is_jump && nearer[i]->uv != end.uv);
      if (is_jump) end = *nearer[i];
      nearer_uv.push_back(end.uv);
    }
    const auto at_nearer = evaluate(surface_, nearer_uv, threads_);
    evaluations_ += steep.size();
    for (std::size_t i = 0; i < steep.size(); ++i) points[steep[i]] = at_nearer[i];
  }
  return points;
}

/// A sheet ends where the surface jumps, or at a boundary, on the way from a corner of its
/// triangles across the chord.
void BoundaryDistance::measure_jumps(std::vector<LeafDistance>& found) {
  auto ends = ends_of_sheets();
  const std::vector<SurfacePoint> at_ends = evaluate_ends(ends);
  std::vector<dvec2> before;  // chords through which sheets go on
  std::vector<bool> goes_on;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const EdgeChord& chord = jumps_[k];
    const dvec2 uv = ends[k] ? ends[k]->uv : chord.opposite;
    const bool is_beyond = glm::dot(uv - chord.middle, chord.beyond - chord.opposite) >= 0;
    goes_on.push_back(ends[k] && is_beyond && ends[k]->kind != SheetEnd::Kind::Jump);
    // The surface may jump on the chord.
    if (goes_on[k]) before.push_back(glm::mix(chord.opposite, chord.middle, 1 - kLastStep));
  }
  const std::vector<SurfacePoint> before_chords = evaluate(surface_, before, threads_);
  evaluations_ += before.size();
  std::size_t next = 0;         // of before_chords
  std::vector<Height> heights;  // of the chord so far
  std::vector<LeafDistance> edges;
  for (std::size_t k = 0; k < ends.size(); ++k) {
    const EdgeChord& chord = jumps_[k];
    if (k % kAlongLine.size() == 0) {
      heights.clear();
      edges.clear();
    }
    const SurfacePoint* const through = goes_on[k] ? &before_chords[next++] : nullptr;
    if (through != nullptr && !counts_before(chord, through->position)) continue;
    if (!ends[k] || !is_seen(clip_, at_ends[k].position)) continue;
    if (through != nullptr) {
      const double distance = distance_from_chord(grid_, chord.ends, through->position);
      found.push_back({chord.leaf, distance, true, before[next - 1]});
      continue;
    }
    const dvec2& uv = ends[k]->uv;
    const double distance = distance_from_edge(
        chord, std::span(&chord.own, chord.triangles.empty() ? 0 : 1), uv, at_ends[k]);
    // Before the chord the mesh sticks out: that is no place of the surface.
    edges.push_back({chord.leaf, distance, true});
    if (is_beyond(chord, uv)) edges.back().uv = uv;
    found.push_back(edges.back());
    heights.push_back({foot(chord.ends[0], chord.ends[1], at_ends[k].position), distance});
    if ((k + 1) % kAlongLine.size() != 0) continue;
    found.push_back(std::ranges::max(edges, {}, &LeafDistance::distance));
    found.back().distance = largest_distance(heights, ends[k - 1], chord.allowed);
  }
}

}  // namespace saddle
