#include "mesh/error/validator.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "mesh/distance/boundary_distance.h"
#include "mesh/distance/crease_distance.h"
#include "mesh/distance/edge_turns.h"
#include "mesh/error/distance_maximizer.h"
#include "mesh/error/sharp_bends.h"
#include "mesh/error/sheet_triangles.h"
#include "mesh/error/validate_many.h"
#include "mesh/features/removable.h"
#include "mesh/model/sides.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// The triangle around a place, and the one beyond its nearest side, if there is one. `known`: the
/// triangle, or nullptr.
PlaceOnTriangle on_triangle(const Grid& grid, std::span<const Triangle> triangles,
                            const Triangle* known, const dvec2& uv) {
  const auto& [below, weights] =
      triangle_below(grid, known != nullptr ? std::span(known, 1) : triangles, uv);
  const Triangle& own = *below;
  std::size_t least = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (weights[static_cast<int>(k)] < weights[static_cast<int>(least)]) least = k;
  }
  // In the triangle's order, with the nearest side from the third to the first.
  const std::array<std::size_t, 3> order = {(least + 2) % 3, least, (least + 1) % 3};
  PlaceOnTriangle place{uv, {}, {}};
  for (std::size_t k = 0; k < 3; ++k) {
    place.corners[(k + 2) % 4] = own[order[k]];
    const double weight = weights[static_cast<int>(order[k])];
    // A place on a side of its triangle is in it.
    place.weights[static_cast<int>(k)] = known != nullptr ? std::max(weight, 0.0) : weight;
  }
  place.corners[1] =
      apex_beyond(triangles, place.corners[2], place.corners[0]).value_or(place.corners[3]);
  return place;
}

/// The part of a segment, from 0 to 1, that is in a box; the second is not larger if none is.
std::array<double, 2> part_within(const Bounds& box, const dvec3& a, const dvec3& b) {
  std::array<double, 2> part = {0, 1};
  for (int k = 0; k < 3; ++k) {
    const double way = b[k] - a[k];
    if (way == 0 && (a[k] < box.low[k] || a[k] > box.high[k])) return {0, 0};
    if (way == 0) continue;
    const double low = (box.low[k] - a[k]) / way;
    const double high = (box.high[k] - a[k]) / way;
    part[0] = std::max(part[0], std::min(low, high));
    part[1] = std::min(part[1], std::max(low, high));
  }
  return part;
}

}  // namespace

/// The smallest error among a leaf's sub-polygons. They meet along a chord of the true feature
/// line; a point between chord and line belongs to the other sub-polygon.
SampledError Validator::sampled_error_of(const Leaf& leaf, std::span<const Triangle> triangles,
                                         const dvec2& uv, const SurfacePoint& point,
                                         double known) const {
  if (!leaf.state.is_cut_by_feature() || triangles.empty())
    return sampled_error(grid_, triangles, uv, point, surface_.flip, known);
  SampledError best{std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity()};
  while (!triangles.empty()) {
    const std::size_t count = count_connected(triangles);
    const SampledError d =
        sampled_error(grid_, triangles.first(count), uv, point, surface_.flip, known);
    best.distance = std::min(best.distance, d.distance);
    best.degrees = std::min(best.degrees, d.degrees);
    triangles = triangles.subspan(count);
  }
  return best;
}

/// Whether triangles cross the clip box: boundaries outside of it do not count.
bool Validator::crosses_box(std::span<const Triangle> triangles) const {
  return reach_outside(clip_, grid_.mesh, triangles);
}

std::vector<std::size_t> Validator::validate_plain(ValidatedMesh& mesh,
                                                   std::span<const std::size_t> which,
                                                   const PartOfTriangles& triangles,
                                                   DistanceMaximizer& maxima) {
  std::vector<TwoTriangles> plain;
  std::vector<std::size_t> numbers;  // of those, in `which`
  std::vector<std::size_t> leaves;
  std::vector<std::size_t> others;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (!triangles.range(k).is_plain || !leaf.has_middle()) {
      others.push_back(k);
      continue;
    }
    const auto two = triangles.of(k);
    numbers.push_back(k);
    leaves.push_back(which[k]);
    plain.push_back({tree_.vertices().parameters(leaf.low),
                     tree_.vertices().parameters(leaf.high()),
                     {two[0], two[1]},
                     validation_places(leaf)});
  }
  const auto sampled_errors = validate_many(surface_, grid_, plain, 1);
  const LeafCentres centres(surface_, mesh, leaves, kFarCentre, tree_, 1);
  evaluations_ += std::tuple_size_v<PlacesInLeaf> * plain.size() + centres.evaluations();
  for (std::size_t i = 0; i < plain.size(); ++i) {
    const std::size_t number = numbers[i];
    const std::size_t leaf = leaves[i];
    // An error above the tolerance may be outside of the clip box.
    if (!sampled_errors[i] || (clip_ && sampled_errors[i]->worst.distance > mesh.allowed[leaf])) {
      others.push_back(number);
      continue;
    }
    mesh.sampled_errors[leaf] = sampled_errors[i]->worst;
    const auto centre = centres.of(i);
    if (centre && is_missed_from_centre(mesh, leaf, *centre, triangles.of(number), grid_))
      maxima.add(leaf, triangles.of(number), centre->uv);
    if (may_be_missed(mesh, leaf, sampled_errors[i]->predicted))
      maxima.add_places(leaf, triangles.of(number), plain[i]);
  }
  return others;
}

std::vector<ValidationPoint> Validator::validate_several(ValidatedMesh& mesh,
                                                         std::span<const std::size_t> which,
                                                         std::span<const std::size_t> others,
                                                         const PartOfTriangles& triangles,
                                                         DistanceMaximizer& maxima) {
  std::vector<ValidationPoint> rest;
  std::vector<ValidationPoint> samples;
  std::vector<PlaceOnTriangle> places;
  for (const std::size_t k : others) {
    const Leaf& leaf = mesh.leaves[which[k]];
    const std::span<const Triangle> of_leaf = triangles.of(k);
    mesh.sampled_errors[which[k]] = {};
    placer_.append(k, leaf, of_leaf, mesh.allowed[which[k]], samples);
    const bool is_special = crosses_box(of_leaf) || leaf.state.is_on_boundary() || of_leaf.empty();
    if (is_special || leaf.state.is_cut_by_feature()) {
      const auto first = samples.begin() + static_cast<std::ptrdiff_t>(places.size());
      const auto one_by_one = std::stable_partition(
          first, samples.end(), [&](const ValidationPoint& s) { return !is_special && !s.crease; });
      rest.insert(rest.end(), one_by_one, samples.end());
      samples.erase(one_by_one, samples.end());
    }
    for (std::size_t s = places.size(); s < samples.size(); ++s) {
      places.push_back(on_triangle(grid_, of_leaf, samples[s].triangle, samples[s].uv));
    }
  }
  const auto found = validate_places(surface_, grid_, places, 1);
  evaluations_ += places.size();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const ValidationPoint& sample = samples[s];
    const std::size_t leaf = which[sample.number];
    // Another sub-polygon of the leaf may be nearer, or the error may be outside of the clip box.
    const bool may_not_count = clip_ || mesh.leaves[leaf].state.is_cut_by_feature();
    const bool is_known =
        found[s] && (!may_not_count || is_good(found[s]->worst, mesh.allowed[leaf]));
    if (!is_known) {
      rest.push_back(sample);
      continue;
    }
    SampledError& worst = mesh.sampled_errors[leaf];
    mesh.add(leaf, found[s]->worst.distance, sample.uv);
    if (!sample.beside_cut) worst.degrees = std::max(worst.degrees, found[s]->worst.degrees);
    if (may_be_missed(mesh, leaf, found[s]->predicted))
      maxima.add(leaf, triangles.of(sample.number), sample.uv);
  }
  return rest;
}

void Validator::validate_one_by_one(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                    const PartOfTriangles& triangles,
                                    std::span<const ValidationPoint> samples) {
  std::vector<dvec2> uv(samples.size());
  std::ranges::transform(samples, uv.begin(), &ValidationPoint::uv);
  const std::vector<SurfacePoint> points = evaluate(surface_, uv, 1);
  evaluations_ += points.size();
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const auto& [k, place, triangle, beside_cut, crease, across] = samples[s];
    const Leaf& leaf = mesh.leaves[which[k]];
    SampledError& worst = mesh.sampled_errors[which[k]];
    const auto of_leaf = triangles.of(k);
    const Seen seen = seen_at(clip_, grid_, of_leaf, place, points[s].position);
    if (!seen.surface && !seen.triangles) continue;
    SampledError d =
        crease ? SampledError{distance_from_chord(grid_, *crease, points[s].position), 0, true}
               : sampled_error_of(leaf, of_leaf, place, points[s], worst.distance);
    // Triangles clipped there may be near the surface elsewhere.
    if (!seen.triangles && !crease) {
      d.distance = distance_from(grid_, of_leaf, place, points[s].position);
    }
    if (crease && moves_by_last_digit(points[s], place, mesh.allowed[which[k]])) continue;
    if (d.distance > worst.distance) {
      mesh.add(which[k], d.distance, place);
      worst.on_crease = d.on_crease;
      worst.is_off_chord = false;
    }
    if (!beside_cut) worst.degrees = std::max(worst.degrees, d.degrees);
  }
}

/// Validates leaves in which the surface turns sharply at more points.
void Validator::validate_sharp_bends(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                     const PartOfTriangles& triangles) {
  SharpBends bends(surface_, grid_, tree_, clip_, 1);
  const LeafCentres centres(surface_, mesh, which, SharpBends::kLeastEstimate, tree_, 1);
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (!crosses_box(triangles.of(k))) bends.add(mesh, which[k], triangles.of(k), centres.of(k));
  }
  bends.measure(mesh);
  evaluations_ += centres.evaluations() + bends.evaluations();
}

/// Adds the distances of triangles beside creases from the surface, at the middles of diagonals and
/// of sides that end in singular points. Beside a cusp the surface turns too much for heights along
/// its normals.
void Validator::validate_beside_creases(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                        const PartOfTriangles& triangles,
                                        std::span<const std::size_t> others) {
  std::vector<MiddleOfChord> chords;
  std::vector<std::size_t> leaves;  // of each
  const Mesh& of = grid_.mesh;
  for (const std::size_t k : others) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (!leaf.state.is_cut_by_feature() || !count_features(leaf, tree_).only_creases) continue;
    if (crosses_box(triangles.of(k))) continue;
    const dvec2 size =
        tree_.vertices().parameters(leaf.high()) - tree_.vertices().parameters(leaf.low);
    for_triangle_sides(triangles.of(k), [&](const Triangle& t, std::size_t side, bool is_diagonal) {
      const std::uint32_t a = t[side];
      const std::uint32_t b = t[(side + 1) % 3];
      const bool goes_to_point =
          tree_.geometry().is_regular_corner(a) != tree_.geometry().is_regular_corner(b);
      if (!is_diagonal && !goes_to_point) return;
      chords.push_back({{of.position[a], of.position[b]},
                        {of.uv[a], of.uv[b]},
                        glm::abs(size),
                        mesh.allowed[which[k]],
                        mesh.sampled_errors[which[k]].distance});
      leaves.push_back(which[k]);
    });
  }
  const std::vector<double> distances = distances_from_surface(surface_, chords, 1);
  for (std::size_t k = 0; k < chords.size(); ++k) {
    mesh.add(leaves[k], distances[k]);
  }
}

/// Adds the distances of the triangles' sides from the surface, in leaves that cross the clip box,
/// at the middles of what is inside. The surface at the same parameters may be far outside.
void Validator::validate_across_faces(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                      const PartOfTriangles& triangles) {
  if (!clip_) return;
  std::vector<MiddleOfChord> chords;
  std::vector<std::size_t> leaves;  // of each
  const auto& position = grid_.mesh.position;
  const auto& uv = grid_.mesh.uv;
  for (std::size_t k = 0; k < which.size(); ++k) {
    const Leaf& leaf = mesh.leaves[which[k]];
    if (!leaf.state.may_be_halved()) continue;
    if (!crosses_box(triangles.of(k)) && !has_cut(FeatureKind::Face, leaf, tree_)) continue;
    const dvec2 size =
        tree_.vertices().parameters(leaf.high()) - tree_.vertices().parameters(leaf.low);
    for_triangle_sides(triangles.of(k), [&](const Triangle& t, std::size_t side, bool) {
      const std::uint32_t a = t[side];
      const std::uint32_t b = t[(side + 1) % 3];
      const auto [begin, end] = part_within(*clip_, position[a], position[b]);
      // The ends of a short part are near the surface.
      const double length = glm::distance(position[a], position[b]) * (end - begin);
      if (!(length > mesh.allowed[which[k]])) return;
      const auto add = [&](double first, double last) {
        const auto at = [&](const auto& of, double share) { return glm::mix(of[a], of[b], share); };
        chords.push_back({{at(position, first), at(position, last)},
                          {at(uv, first), at(uv, last)},
                          glm::abs(size),
                          mesh.allowed[which[k]],
                          mesh.sampled_errors[which[k]].distance});
        leaves.push_back(which[k]);
      };
      add(begin, end);
      // On its way to a face a side is farthest from the surface near the face.
      const bool ends_at_a = tree_.vertices().is_on_feature(a);
      if (ends_at_a == tree_.vertices().is_on_feature(b)) return;
      const double middle = 0.5 * (begin + end);
      if (ends_at_a) add(begin, middle);
      if (!ends_at_a) add(middle, end);
    });
  }
  const std::vector<double> distances = distances_from_surface(surface_, chords, 1);
  for (std::size_t k = 0; k < chords.size(); ++k) mesh.add(leaves[k], distances[k]);
}

/// Adds the distances of corners that only triangles without area have: these are left out, and the
/// surface at such a corner may stick out of the other triangles.
void Validator::validate_omitted_corners(ValidatedMesh& mesh, std::size_t number,
                                         std::span<const Triangle> triangles) const {
  const Leaf& leaf = mesh.leaves[number];
  if (!leaf.state.is_whole() || triangles.empty()) return;
  if (triangles.size() + 2 >= leaf.polygon_size) return;
  const auto& point = grid_.mesh.point;
  for_sides(leaf, tree_, [&](std::uint32_t vertex, std::uint32_t) {
    const auto has_it = [&](const Triangle& t) {
      return std::ranges::any_of(t, [&](auto corner) { return point[corner] == point[vertex]; });
    };
    const dvec3& position = grid_.mesh.position[vertex];
    if (std::ranges::any_of(triangles, has_it)) return;
    if (clip_ && !clip_->contains(position)) return;
    const dvec2& uv = grid_.mesh.uv[vertex];
    mesh.add(number, distance_from(grid_, triangles, uv, position), uv);
  });
}

void Validator::measure(ValidatedMesh& mesh, std::span<const std::size_t> which,
                        const PartOfTriangles& triangles) {
  DistanceMaximizer maxima(surface_, grid_, clip_, 1);
  const std::vector<std::size_t> others = validate_plain(mesh, which, triangles, maxima);
  std::vector<ValidationPoint> rest = validate_several(mesh, which, others, triangles, maxima);
  move_onto_creases(surface_, rest, 1);
  placer_.append_singular_sides(mesh, which, rest);
  validate_one_by_one(mesh, which, triangles, rest);
  maxima.climb(mesh);
  evaluations_ += maxima.evaluations();
  validate_sharp_bends(mesh, which, triangles);
  validate_beside_creases(mesh, which, triangles, others);
  validate_across_faces(mesh, which, triangles);
  for (const std::size_t k : others) validate_omitted_corners(mesh, which[k], triangles.of(k));
  EdgeTurns edges(surface_, grid_, clip_, 1);
  for (std::size_t k = 0; k < which.size(); ++k) {
    if (mesh.is_near(which[k])) edges.add_sides(which[k], triangles.of(k), mesh.allowed[which[k]]);
  }
  for (const LeafDistance& at : edges.measure(kInfinity)) mesh.add(at.leaf, at.distance, at.uv);
  evaluations_ += edges.evaluations();
  BoundaryDistance boundaries(surface_, grid_, tree_, clip_, 1);
  for (const std::size_t k : others)
    boundaries.add(mesh.leaves[which[k]], which[k], triangles.of(k), mesh.allowed[which[k]]);
  for (const auto& [leaf, distance, is_at_jump, uv] : boundaries.measure()) {
    // A predicted distance may be as large as the tolerance.
    if (distance >= mesh.allowed[leaf]) mesh.sampled_errors[leaf].is_off_chord = true;
    if (is_at_jump && distance > mesh.sampled_errors[leaf].distance)
      mesh.sampled_errors[leaf].on_crease = true;
    mesh.add(leaf, distance, uv);
  }
  evaluations_ += boundaries.evaluations();
  looks_ += boundaries.looks();
  SheetTriangles sheets(surface_, grid_, tree_, 1);
  for (const std::size_t k : others) {
    if (!crosses_box(triangles.of(k))) sheets.add(mesh, which[k], triangles.of(k));
  }
  sheets.measure(mesh);
}

}  // namespace saddle
