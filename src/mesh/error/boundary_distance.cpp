#include "mesh/error/boundary_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/error/sampled_error.h"
#include "mesh/features/approach.h"
#include "mesh/features/sheet_ends.h"
#include "mesh/model/sides.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// Halvings of the way across a leaf to its boundary: 1e-6 of it is enough for a distance.
constexpr int kWayHalvings = 20;

/// Where a leaf without triangles is sampled, in sides of the leaf, and the directions from there
/// to its border.
constexpr std::array kLeafPlaces = {dvec2(0.5, 0.5), dvec2(0.3, 0.2), dvec2(0.8, 0.3),
                                    dvec2(0.7, 0.8), dvec2(0.2, 0.7)};
constexpr std::array kLeafDirections = {dvec2(0, 1), dvec2(0, -1), dvec2(1, 0), dvec2(-1, 0)};
/// The surface is looked at just before a chord, as far as bisections go: it may jump on it.
constexpr double kBeforeChord = 1 - 1.0 / (1 << kWayHalvings);
/// Places on the chord of a jump, in its length: a line that turns in the chord's middle is not
/// missed. A corner of a boundary is solved for; its arc is farthest in the middle.
constexpr std::array kJumpPlaces = {0.25, 0.5, 0.75};
constexpr std::array kBoundaryPlaces = {0.5};
constexpr std::size_t kPlaceGroup = 1 + kLeafDirections.size();  // a place and those beside it

}  // namespace

void BoundaryDistance::add(const Leaf& leaf, std::size_t number,
                           std::span<const Triangle> triangles, double allowed) {
  if (leaf.state.is_cut_by_feature() && has_cut(FeatureKind::Jump, leaf, tree_)) {
    if (leaf.state.leads_to_pole() || has_cut(FeatureKind::Pole, leaf, tree_)) return;
    delta_ = std::min(delta_, allowed);
    if (!triangles.empty()) return add_chords(leaf, number, triangles, true);
  } else {
    if (leaf.state.cut() != LeafCut::Boundary) return;
    if (!triangles.empty()) return add_chords(leaf, number, triangles, false);
  }
  omitted_.push_back(number);
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high) - low;
  for (const dvec2& place : kLeafPlaces) {
    places_in_omitted_.push_back(low + size * place);
    for (const dvec2& way : kLeafDirections)
      places_in_omitted_.push_back(low + size * border_of_square(place, way));
  }
}

void BoundaryDistance::add_chords(const Leaf& leaf, std::size_t number,
                                  std::span<const Triangle> triangles, bool is_jump) {
  const std::span<const double> places =
      is_jump ? std::span<const double>(kJumpPlaces) : std::span<const double>(kBoundaryPlaces);
  std::vector<EdgeChord>& chords = is_jump ? jumps_ : chords_;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high) - low;
  const bool is_at_face = has_cut(FeatureKind::Face, leaf, tree_);
  const auto place = [&](std::uint32_t corner) { return (grid_.mesh.uv[corner] - low) / size; };
  for (const Triangle& t : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = t[i];
      const std::uint32_t b = t[(i + 1) % 3];
      const std::uint32_t opposite = t[(i + 2) % 3];
      if (has_side(triangles, b, a)) continue;  // a diagonal
      const dvec2 middle = 0.5 * (place(a) + place(b));
      if (!is_chord(middle, {a, b}, tree_)) continue;
      const dvec2 outward = glm::mix(place(a), place(b), foot(a, b, opposite)) - place(opposite);
      if (outward == dvec2(0)) continue;
      for (const double share : places) {
        const dvec2 at = glm::mix(place(a), place(b), share);
        // A jump is looked for from the corner, which is on the sheet, through the place.
        const dvec2 way = is_jump ? at - place(opposite) : outward;
        chords.push_back({number,
                          is_jump ? std::span(&t, 1) : triangles,
                          {a, b},
                          low + size * at,
                          grid_.mesh.uv[opposite],
                          low + size * border_of_square(at, -way),
                          low + size * border_of_square(at, way),
                          is_at_face});
      }
    }
  }
}

std::vector<BoundaryDistance::LeafDistance> BoundaryDistance::measure() {
  std::vector<LeafDistance> found;
  if (!chords_.empty()) measure_chords(found);
  if (!jumps_.empty()) measure_jumps(found);
  if (!omitted_.empty()) measure_omitted(found);
  return found;
}

/// The part of the way from one vertex to another at which a third is straight above it.
double BoundaryDistance::foot(std::uint32_t from, std::uint32_t to, std::uint32_t above) const {
  const dvec3 edge = grid_.local(to) - grid_.local(from);
  const double square = glm::dot(edge, edge);
  return square > 0 ? glm::dot(grid_.local(above) - grid_.local(from), edge) / square : 0.5;
}

/// Where the surface, or its part in the clip box, ends on ways across chords.
std::vector<dvec2> BoundaryDistance::ends_of(std::span<const Line> ways) const {
  std::vector<dvec2> ends = last_defined(surface_, ways, kWayHalvings, threads_, clip_);
  std::vector<Line> to_faces;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (chords_[k].is_at_face) to_faces.push_back({ends[k], ways[k][1]});
  }
  const auto faces = last_defined(surface_, to_faces, kHalvingsToLeast, threads_, clip_);
  std::size_t next = 0;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    if (chords_[k].is_at_face) ends[k] = faces[next++];
  }
  return ends;
}

/// Ways across chords that cross the boundary: outward if the surface is seen at the chord's
/// middle, else from inside to the middle.
std::vector<Line> BoundaryDistance::ways_to_boundary(std::span<const SurfacePoint> at_middle) {
  std::vector<dvec2> across;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    if (!is_seen(at_middle[k].position)) across.push_back(chords_[k].across);
  }
  const std::vector<SurfacePoint> at_across = evaluate(surface_, across, threads_);
  evaluations_ += across.size();
  std::vector<Line> ways;
  std::size_t next = 0;
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const EdgeChord& chord = chords_[k];
    if (is_seen(at_middle[k].position)) {
      ways.push_back({chord.middle, chord.beyond});
    } else {
      const bool is_inside = is_seen(at_across[next++].position);
      ways.push_back({is_inside ? chord.across : chord.opposite, chord.middle});
    }
  }
  return ways;
}

/// The surface's boundary may be on either side of its chord: the mesh covers too much or too
/// little. All that is between chord and boundary is an error.
void BoundaryDistance::measure_chords(std::vector<LeafDistance>& found) {
  std::vector<dvec2> middles;
  for (const EdgeChord& chord : chords_) middles.push_back(chord.middle);
  const std::vector<SurfacePoint> at_middle = evaluate(surface_, middles, threads_);
  const std::vector<dvec2> boundary = ends_of(ways_to_boundary(at_middle));
  const std::vector<SurfacePoint> at_boundary = evaluate(surface_, boundary, threads_);
  evaluations_ += chords_.size() * (2 + kWayHalvings);
  for (std::size_t k = 0; k < chords_.size(); ++k) {
    const EdgeChord& chord = chords_[k];
    found.push_back({chord.leaf, distance_from_edge(chord, boundary[k], at_boundary[k])});
    if (!is_seen(at_middle[k].position)) continue;
    found.push_back(
        {chord.leaf, distance_from(grid_, chord.triangles, chord.middle, at_middle[k].position)});
  }
}

/// The distance of a point of the edge from its chord, or from the triangles where it lies beyond
/// the chord's ends. Beside a clip box chords lie along its faces, and only triangles count.
double BoundaryDistance::distance_from_edge(const EdgeChord& chord, const dvec2& uv,
                                            const SurfacePoint& point) const {
  const double from_chord = distance_from_chord(grid_, chord.ends, point.position);
  const bool is_beyond = glm::dot(uv - chord.middle, chord.beyond - chord.middle) >= 0;
  if (!is_beyond) return from_chord;
  const double from_triangles = distance_from(grid_, chord.triangles, uv, point.position);
  return clip_ ? from_triangles : std::max(from_chord, from_triangles);
}

/// A sheet ends where the surface jumps, or at a boundary, on the way from a corner of its
/// triangles across the chord.
void BoundaryDistance::measure_jumps(std::vector<LeafDistance>& found) {
  std::vector<Line> ways;
  for (const EdgeChord& chord : jumps_) ways.push_back({chord.opposite, chord.beyond});
  const auto ends = sheet_ends(surface_, ways, delta_, kWayHalvings, clip_, threads_, evaluations_);
  std::vector<dvec2> uv;
  for (std::size_t k = 0; k < ways.size(); ++k) {
    uv.push_back(ends[k] ? ends[k]->uv : ways[k][0]);
    uv.push_back(glm::mix(jumps_[k].opposite, jumps_[k].middle, kBeforeChord));
  }
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, threads_);
  evaluations_ += uv.size();
  for (std::size_t k = 0; k < ways.size(); ++k) {
    const EdgeChord& chord = jumps_[k];
    const auto add = [&](double distance) { found.push_back({chord.leaf, distance, true}); };
    const SurfacePoint& at_end = points[2 * k];
    if (!ends[k] || !is_seen(at_end.position)) continue;
    const bool is_beyond = glm::dot(uv[2 * k] - chord.middle, chord.beyond - chord.opposite) >= 0;
    if (!is_beyond || ends[k]->kind == SheetEnd::Kind::Jump)
      add(distance_from_edge(chord, uv[2 * k], at_end));
    // Without a jump the sheet goes on through the chord.
    if (is_beyond && ends[k]->kind != SheetEnd::Kind::Jump)
      add(distance_from_chord(grid_, chord.ends, points[2 * k + 1].position));
  }
}

/// Leaves may be defined in places but not at their corners, as beside the point where a boundary
/// touches the edge of the domain. The missing part is measured from the leaf's border, where
/// neighbours are.
void BoundaryDistance::measure_omitted(std::vector<LeafDistance>& found) {
  const std::vector<SurfacePoint> points = evaluate(surface_, places_in_omitted_, threads_);
  evaluations_ += points.size();
  for (std::size_t k = 0; k < points.size(); k += kPlaceGroup) {
    if (!is_seen(points[k].position)) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t way = 1; way < kPlaceGroup; ++way) {
      const dvec3& beside = points[k + way].position;
      if (is_finite(beside)) nearest = std::min(nearest, glm::distance(beside, points[k].position));
    }
    found.push_back({omitted_[k / (kPlaceGroup * kLeafPlaces.size())], nearest});
  }
}

}  // namespace saddle
