#include "mesh/distance/boundary_distance.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "mesh/distance/sampled_error.h"
#include "mesh/distance/sheet_view.h"
#include "mesh/features/approach.h"
#include "mesh/features/way_out.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Between a face and a boundary without a limit, as of u/sqrt(v) at u=0, an edge is a parabola of
/// parameters: all but 1/16 of it is before the place that is nearest to its end.
constexpr std::array kMiddleAndNearEnds = {0.5, 1.0 / 256, 255.0 / 256};

/// Where chords of a boundary are looked across.
std::span<const double> places_on_edge(bool is_at_face) {
  return is_at_face ? std::span<const double>(kMiddleAndNearEnds) : std::span(kMiddleOfLine);
}

}  // namespace

void BoundaryDistance::add(const Leaf& leaf, std::size_t number,
                           std::span<const Triangle> triangles, double allowed) {
  if (reach_outside(clip_, grid_.mesh, triangles))
    return add_across_face(leaf, number, triangles, allowed);
  const bool is_cut = leaf.state.is_cut_by_feature();
  if (is_cut && has_cut(FeatureKind::Cliff, leaf, tree_)) {
    delta_ = std::min(delta_, allowed);
    return add_chords(leaf, number, triangles, FeatureKind::Cliff, allowed);
  }
  if (is_cut && has_cut(FeatureKind::Jump, leaf, tree_))
    return add_at_jump(leaf, number, triangles, allowed);
  if (!leaf.state.is_on_boundary() || leaf.state.leads_to_pole()) return;
  // A crest in a strip has chords of its own, and beside poles rims are places without a value.
  // Other rims may have a feature of a neighbour.
  const auto has = [&](FeatureKind kind) { return has_cut(kind, leaf, tree_); };
  if (is_cut && (clip_ || has(FeatureKind::Pole) || has(FeatureKind::Essential) ||
                 has(FeatureKind::Crease) || has_thin_strip(leaf, tree_)))
    return;
  if (strips_.add(leaf, number, triangles, allowed)) {
    if (triangles.empty())
      add_bulges(leaf, number, allowed);  // the strip may end before the first line
  } else if (triangles.empty()) {
    add_omitted(leaf, number, allowed, false);
  } else {
    add_chords(leaf, number, triangles, FeatureKind::Boundary, allowed);
  }
}

/// Adds a leaf that the clip box cuts. Chords may be beyond the box. A boundary's count on the way
/// to a pole, where the edge may be in it.
void BoundaryDistance::add_across_face(const Leaf& leaf, std::size_t number,
                                       std::span<const Triangle> triangles, double allowed) {
  const bool has_face = has_cut(FeatureKind::Face, leaf, tree_);
  const auto add_outward = [&](FeatureKind kind, std::vector<EdgeChord>& chords) {
    const std::size_t first = chords.size();
    add_chords(leaf, number, triangles, kind, allowed);
    for (EdgeChord& chord : std::span(chords).subspan(first)) chord.is_outward = true;
  };
  if (has_face && leaf.state.cut() == LeafCut::Boundary)
    add_outward(FeatureKind::Boundary, chords_);
  if (has_face || !has_cut(FeatureKind::Jump, leaf, tree_) || leaf.state.leads_to_pole() ||
      has_cut(FeatureKind::Pole, leaf, tree_))
    return;
  delta_ = std::min(delta_, allowed);
  add_outward(FeatureKind::Jump, jumps_);
}

void BoundaryDistance::add_omitted(const Leaf& leaf, std::size_t number, double allowed,
                                   bool is_at_jump) {
  add_bulges(leaf, number, allowed);
  omitted_.add(leaf, number, is_at_jump);
}

/// The place at a share of the way along a chord. The leaf's corners would round it: between ends
/// at u=1e-34 it would be at u=0.
dvec2 BoundaryDistance::on_chord(const Chord& ends, double share) const {
  return glm::mix(grid_.mesh.uv[ends[0]], grid_.mesh.uv[ends[1]], share);
}

/// Adds the stretches of the sides of a leaf without triangles between two boundaries, edge by
/// edge: the surface reaches into the leaf there, if it is defined in an edge's middle.
void BoundaryDistance::add_bulges(const Leaf& leaf, std::size_t number, double allowed) {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t vertex) { return (grid_.mesh.uv[vertex] - low) / size; };
  const auto boundary_on = [&](const Side& side) {
    const std::optional<EdgeFeature> feature = tree_.edges().feature(side[0], side[1]);
    return feature && feature->is_boundary() ? feature : std::nullopt;
  };
  const std::span<const double> places = places_on_edge(has_cut(FeatureKind::Face, leaf, tree_));
  std::vector<Side> sides;  // from where the surface enters the leaf on
  for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t b) { sides.push_back({a, b}); });
  const auto enters = std::ranges::find_if(sides, [&](const Side& side) {
    return tree_.geometry().is_defined(side[1]) && boundary_on(side);
  });
  std::rotate(sides.begin(), enters, sides.end());
  std::vector<std::uint32_t> stretch;  // empty outside
  for (const Side& side : sides) {
    const std::optional<EdgeFeature> feature = boundary_on(side);
    const std::uint32_t b = side[1];
    if (!feature) {
      if (!stretch.empty()) stretch.push_back(b);
      continue;
    }
    const std::uint32_t end = feature->beside_first;
    if (!stretch.empty()) stretch.push_back(end);
    for (std::size_t k = 1; k < stretch.size(); ++k) {
      const dvec2 along = place(stretch[k]) - place(stretch[k - 1]);
      if (along == dvec2(0)) continue;
      for (const double share : places) {
        const Chord ends = {stretch[k - 1], stretch[k]};
        const dvec2 start = glm::mix(place(ends[0]), place(ends[1]), share);
        const dvec2 at = on_chord(ends, share);
        // Counter-clockwise, the leaf is to the left.
        const dvec2 beyond = low + size * border_of_square(start, {-along.y, along.x});
        chords_.push_back({number, allowed, {}, {}, ends, at, at, at, beyond, std::nullopt, false});
        chords_.back().is_outward = share != kMiddleOfLine[0];
      }
    }
    stretch.clear();
    if (tree_.geometry().is_defined(b)) stretch = {end, b};
  }
}

/// The sides of a triangle that are chords of a boundary or jump.
std::vector<BoundaryDistance::OuterSide> BoundaryDistance::outer_chords(
    const Leaf& leaf, const Triangle& t, const CellTriangles& by_sides) const {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t corner) { return (grid_.mesh.uv[corner] - low) / size; };
  std::vector<OuterSide> chords;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::uint32_t a = t[i];
    const std::uint32_t b = t[(i + 1) % 3];
    const std::uint32_t opposite = t[(i + 2) % 3];
    if (by_sides.has_side(b, a)) continue;  // a diagonal
    const dvec2 middle = 0.5 * (place(a) + place(b));
    if (!is_chord(middle, {a, b}, tree_)) continue;
    const dvec2 outward =
        glm::mix(place(a), place(b), foot(a, b, grid_.mesh.position[opposite])) - place(opposite);
    if (outward != dvec2(0)) chords.push_back({a, b, opposite, outward});
  }
  return chords;
}

void BoundaryDistance::add_chords(const Leaf& leaf, std::size_t number,
                                  std::span<const Triangle> triangles, FeatureKind kind,
                                  double allowed) {
  const bool is_jump = kind != FeatureKind::Boundary;
  const bool is_cliff = kind == FeatureKind::Cliff;
  // Ways through the places on a jump are not straight across: the largest distance is predicted.
  // A rim's arc is farthest in the middle; measure_chords() looks for corners beside it.
  const bool is_at_face = has_cut(FeatureKind::Face, leaf, tree_);
  const std::span<const double> places =
      is_jump ? std::span<const double>(kAlongLine) : places_on_edge(is_at_face);
  std::vector<EdgeChord>& chords = is_jump ? jumps_ : chords_;
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t corner) { return (grid_.mesh.uv[corner] - low) / size; };
  const CellTriangles by_sides(triangles);
  std::vector<std::array<std::uint32_t, 3>> turning;
  for (std::uint32_t k = 0; k < triangles.size(); ++k) {
    const Triangle& t = triangles[k];
    // Chords are measured from the sheets on either side of a cliff.
    if (is_cliff && std::ranges::all_of(t, [&](std::uint32_t corner) {
          return tree_.vertices().is_on_feature(corner);
        }))
      continue;
    const std::vector<OuterSide> sides = outer_chords(leaf, t, by_sides);
    if (sides.empty()) continue;
    const std::vector<Triangle> sheet = by_sides.connected_to(k);
    std::vector<PlacedTriangle> placed(sheet.size());
    std::ranges::transform(sheet, placed.begin(), [&](const Triangle& other) {
      return PlacedTriangle{other, {place(other[0]), place(other[1]), place(other[2])}};
    });
    for (const auto& [a, b, opposite, outward] : sides) {
      if (!is_jump) beyond_.add({low, low + size}, number, triangles, {a, b, opposite}, allowed);
      turning.push_back({a, b, opposite});
      for (const double share : places) {
        const dvec2 at = glm::mix(place(a), place(b), share);
        // A jump is looked for from a corner, which is on the sheet, through the place.
        const std::uint32_t from =
            is_jump ? corner_across(grid_, {a, b}, share, at, opposite, placed) : opposite;
        const dvec2 way = is_jump ? at - place(from) : outward;
        const dvec2 border = border_of_square(at, way);
        chords.push_back({number,
                          allowed,
                          triangles,
                          t,
                          {a, b},
                          on_chord({a, b}, share),
                          grid_.mesh.uv[from],
                          low + size * border_of_square(at, -way),
                          low + size * border,
                          outside_of(leaf, sheet, border, way),
                          is_at_face,
                          !is_jump && share != kMiddleOfLine[0],
                          is_cliff});
      }
    }
  }
  turns_.add_chords(number, triangles, turning, allowed);
}

/// A place in the next leaf, on a way that leaves a leaf at its border. None where the sheet has a
/// corner on that side, which the next leaf shares, or the domain ends.
std::optional<dvec2> BoundaryDistance::outside_of(const Leaf& leaf, std::span<const Triangle> sheet,
                                                  const dvec2& border, const dvec2& way) const {
  const dvec2 low = tree_.vertices().parameters(leaf.low);
  const dvec2 size = tree_.vertices().parameters(leaf.high()) - low;
  const auto place = [&](std::uint32_t corner) { return (grid_.mesh.uv[corner] - low) / size; };
  const auto is_between = [](const dvec2& at, const dvec2& a, const dvec2& b) {
    return std::fabs(cross(b - a, at - a)) < kSame && glm::dot(at - a, at - b) <= kSame;
  };
  bool is_shared = false;
  for_sides(leaf, tree_, [&](std::uint32_t a, std::uint32_t b) {
    if (!is_between(border, place(a), place(b))) return;
    for (const Triangle& t : sheet) {
      for (const std::uint32_t corner : t)
        is_shared = is_shared || is_between(place(corner), place(a), place(b));
    }
  });
  if (is_shared) return std::nullopt;
  const dvec2 reach = way / std::max(std::fabs(way.x), std::fabs(way.y));
  const dvec2 outside = low + size * (border + reach);
  if (nearest_in(box_of(surface_.domain), outside) != outside) return std::nullopt;
  return outside;
}

std::vector<LeafDistance> BoundaryDistance::measure() {
  std::vector<LeafDistance> found = strips_.measure();
  evaluations_ += strips_.evaluations();
  measure_chords(found);
  std::ranges::copy(beyond_.measure(), std::back_inserter(found));
  if (!jumps_.empty()) measure_jumps(found);
  std::ranges::copy(on_sides_, std::back_inserter(found));
  std::ranges::copy(close_jumps_.measure(delta_), std::back_inserter(found));
  std::ranges::copy(turns_.measure(delta_), std::back_inserter(found));
  evaluations_ += close_jumps_.evaluations() + turns_.evaluations();
  looks_ += beyond_.looks() + close_jumps_.looks();
  std::ranges::copy(omitted_.measure(), std::back_inserter(found));
  evaluations_ += omitted_.evaluations();
  return found;
}

/// The part of the way from one vertex to another at which a position is straight above it.
double BoundaryDistance::foot(std::uint32_t from, std::uint32_t to, const dvec3& above) const {
  const dvec3 edge = grid_.local(to) - grid_.local(from);
  const double square = glm::dot(edge, edge);
  const dvec3 way = grid_.local_scale * above - grid_.local(from);
  return square > 0 ? glm::dot(way, edge) / square : 0.5;
}

/// Whether a place is on the outer side of a chord.
bool BoundaryDistance::is_beyond(const EdgeChord& chord, const dvec2& uv) {
  return glm::dot(uv - chord.middle, chord.beyond - chord.middle) >= 0;
}

/// The distance of a point of the edge from its chord, and from the triangles where the point lies
/// beyond the chord. Beside a face of the clip box the chord does not count. A leaf without
/// triangles has chords on its sides alone.
double BoundaryDistance::distance_from_edge(const EdgeChord& chord,
                                            std::span<const Triangle> triangles, const dvec2& uv,
                                            const SurfacePoint& point) const {
  const double from_chord = distance_from_chord(grid_, chord.ends, point.position);
  if (!is_beyond(chord, uv) || triangles.empty()) return from_chord;
  const double from_triangles = distance_from(grid_, triangles, uv, point.position);
  const auto& position = grid_.mesh.position;
  const bool is_along =
      clip_ && is_along_face(*clip_, position[chord.ends[0]], position[chord.ends[1]]);
  return is_along ? from_triangles : std::max(from_chord, from_triangles);
}

}  // namespace saddle
