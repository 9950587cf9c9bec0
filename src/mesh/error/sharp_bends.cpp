#include "mesh/error/sharp_bends.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>

#include "mesh/distance/crease_distance.h"
#include "mesh/features/removable.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/sides.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// A triangle bridges a bend if its normal is over 30 degrees from the mean of its corners'.
constexpr double kBridgedCosineSquare = 0.75;
/// Assumption: a leaf validated below 0.5 tolerances, or whose bridges are thinner, needs no more
/// points, but beside the corners of thin bridges.
constexpr double kDoubtful = 0.5;
/// Assumption: a leaf estimated below 0.75 tolerances needs no points on its sides, and a triangle
/// no search if its places are nearer to the surface.
constexpr double kDoubtfulSides = 0.75;
/// Places on a leaf's middle lines, as parts of its sides. Random points are at 0.15 to 0.35.
constexpr std::array kOnLines = {0.1, 0.9};
/// Steps of the compass search as parts of the leaf's sides, each tried in four directions.
constexpr std::array kStepShares = {0.2, 0.1, 0.05};
/// A side that leaves the surface at a corner is farthest from a wall beside the corner: 1.25
/// tolerances from the corner's tangent plane, where the corner is not near.
constexpr double kBelowCorner = 1.25;

/// Whether normals at opposite corners are as far apart as kSteepCosine. There, and where
/// interpolated normals are off by kSharpDegrees, an arc is no parabola, and predictions fail.
bool turns_sharply(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner) {
  const auto turns = [&](std::size_t a, std::size_t b) {
    return glm::dot(mesh.normal[corner[a]], mesh.normal[corner[b]]) < kSteepCosine;
  };
  return turns(0, 2) || turns(1, 3);
}

/// Whether a triangle's normal is that of none of its corners. Beside a wall all corners may be on
/// the same side of its foot.
bool bridges_bend(const Mesh& mesh, const Triangle& t) {
  const dvec3 a = mesh.position[t[1]] - mesh.position[t[0]];
  const dvec3 b = mesh.position[t[2]] - mesh.position[t[0]];
  const dvec3 area = glm::cross(a, b);
  const dvec3 normal = mesh.normal[t[0]] + mesh.normal[t[1]] + mesh.normal[t[2]];
  const double along = glm::dot(area, normal);
  const double squares = glm::dot(area, area) * glm::dot(normal, normal);
  return along < 0 || along * along < kBridgedCosineSquare * squares;
}

/// Whether a leaf on the boundary holds both edges of a strip.
bool is_strip(const Leaf& leaf, const CellTree& tree) {
  const auto has = [&](FeatureKind kind) { return has_cut(kind, leaf, tree); };
  return count_features(leaf, tree).features > 2 && !has(FeatureKind::Face) &&
         !has(FeatureKind::Pole) && !has(FeatureKind::Essential);
}

/// The box around the parameters of triangles.
ParameterBox box_around(std::span<const Triangle> triangles, const Mesh& mesh) {
  const dvec2& first = mesh.uv[triangles[0][0]];
  ParameterBox box{first, first};
  for (const Triangle& t : triangles) {
    for (const std::uint32_t corner : t) {
      box.low = glm::min(box.low, mesh.uv[corner]);
      box.high = glm::max(box.high, mesh.uv[corner]);
    }
  }
  return box;
}

/// The side that a leaf's two triangles share.
std::array<std::uint32_t, 2> diagonal_of(std::span<const Triangle> two) {
  const Triangle& t = two[0];
  const auto tip = std::ranges::find_if(
      t, [&](std::uint32_t corner) { return std::ranges::find(two[1], corner) == two[1].end(); });
  const auto at = static_cast<std::size_t>(tip - t.begin());
  return {t[(at + 1) % 3], t[(at + 2) % 3]};
}

/// The distance of the middle of a leaf's diagonal from the surface, to second order: from the
/// tangent plane at the leaf's centre and the change of normals towards the middle.
double distance_of_diagonal(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner,
                            const LeafCentre& centre,
                            const std::array<std::uint32_t, 2>& diagonal) {
  const auto& position = mesh.position;
  const auto& normal = mesh.normal;
  const auto along = [&](const auto& of, std::size_t from, std::size_t to) {
    return of[corner[from]] - of[corner[to]];
  };
  const dvec3 r_u = along(position, 1, 0) + along(position, 2, 3);
  const dvec3 r_v = along(position, 3, 0) + along(position, 2, 1);
  const dvec3 n_u = along(normal, 1, 0) + along(normal, 2, 3);
  const dvec3 n_v = along(normal, 3, 0) + along(normal, 2, 1);
  const dvec3 off = 0.5 * (position[diagonal[0]] + position[diagonal[1]]) - centre.position;
  const double height = glm::dot(off, centre.normal);
  const dvec3 aside = off - height * centre.normal;
  // aside = p r_u + q r_v, by least squares.
  const double uu = glm::dot(r_u, r_u);
  const double uv = glm::dot(r_u, r_v);
  const double vv = glm::dot(r_v, r_v);
  const double on_u = glm::dot(aside, r_u);
  const double on_v = glm::dot(aside, r_v);
  const double p = on_u * vv - on_v * uv;
  const double q = on_v * uu - on_u * uv;
  return std::fabs(height + 0.5 * glm::dot(aside, p * n_u + q * n_v) / (uu * vv - uv * uv));
}

}  // namespace

void SharpBends::add(const ValidatedMesh& mesh, std::size_t number,
                     std::span<const Triangle> triangles, const std::optional<LeafCentre>& centre) {
  if (!mesh.is_near(number) || triangles.empty()) return;
  const Leaf& leaf = mesh.leaves[number];
  const std::optional<Targets> targets = targets_of(mesh, number, triangles, centre);
  if (!targets) return;
  ParameterBox box = tree_.box(leaf);
  if (targets->in_strip) box = box_around(triangles, grid_.mesh);
  leaves_.push_back({number, box.low, box.high, triangles, *targets});
}

std::optional<SharpBends::Targets> SharpBends::targets_of(
    const ValidatedMesh& mesh, std::size_t number, std::span<const Triangle> triangles,
    const std::optional<LeafCentre>& centre) const {
  const Leaf& leaf = mesh.leaves[number];
  bool is_bridged = false;
  bool has_thick_bridge = false;
  for (const Triangle& t : triangles) {
    if (!bridges_bend(grid_.mesh, t)) continue;
    is_bridged = true;
    has_thick_bridge |= thickness_of(grid_.mesh, t) > kDoubtful * mesh.allowed[number];
  }
  if (is_bridged && (leaf.state.is_whole() || count_features(leaf, tree_).is_continuous))
    return Targets{has_thick_bridge, false, has_thick_bridge, true};
  const bool is_doubtful = mesh.error_ratio(number) > kDoubtful;
  if (!leaf.state.is_whole()) {
    // Between both edges of a strip, and from a pole to the clip box, the surface may rise and turn
    // where few samples are. Near a pole it may be where no search from triangles comes.
    if (leaf.state.is_on_boundary() && is_strip(leaf, tree_))
      return Targets{is_doubtful, false, true, is_doubtful, true};
    const bool is_at_face = is_doubtful && has_cut(FeatureKind::Face, leaf, tree_);
    return is_at_face ? std::optional(Targets{true, false, true}) : std::nullopt;
  }
  const Targets targets{is_doubtful, leaf.known_error > kDoubtfulSides};
  const bool is_sharp = turns_sharply(grid_.mesh, leaf.samples.corner);
  // Heights along normals, of which estimates are made, are no distances there.
  if (is_sharp && has_far_middle(leaf, mesh.allowed[number]))
    return Targets{is_doubtful, targets.sides, false, true};
  if (!targets.places && !targets.sides) return std::nullopt;
  if (is_sharp) return targets;
  if (mesh.sampled_errors[number].degrees > kSharpDegrees) {
    return Targets{targets.places, targets.sides, true};
  }
  if (!centre || triangles.size() != 2) return std::nullopt;
  const double distance =
      distance_of_diagonal(grid_.mesh, leaf.samples.corner, *centre, diagonal_of(triangles));
  return distance > mesh.allowed[number] ? std::optional(Targets{false, true}) : std::nullopt;
}

/// Whether a sample of the leaf is farther than allowed from the middle of its chord.
bool SharpBends::has_far_middle(const Leaf& leaf, double allowed) const {
  const auto& position = grid_.mesh.position;
  const auto& [corner, side, centre] = leaf.samples;
  const auto is_far = [&](std::uint32_t a, std::uint32_t b, std::uint32_t sample) {
    if (sample == SampleVertices::kUnasked) return false;
    const dvec3 middle = 0.5 * (position[a] + position[b]);
    return glm::distance(middle, position[sample]) > allowed;
  };
  for (std::size_t k = 0; k < 4; ++k) {
    if (is_far(corner[k], corner[(k + 1) % 4], side[k])) return true;
  }
  return is_far(corner[0], corner[2], centre) && is_far(corner[1], corner[3], centre);
}

void SharpBends::append_places(std::size_t number, std::vector<Place>& places) const {
  const SharpLeaf& leaf = leaves_[number];
  const auto append = [&](const dvec2& part) {
    places.push_back({number, glm::mix(leaf.low, leaf.high, part)});
  };
  if (leaf.targets.everywhere) {
    for (const double u : kAllAlongLine) {
      for (const double v : kAllAlongLine) append({u, v});
    }
    return;
  }
  for (const double share : kOnLines) {
    append({share, 0.5});
    append({0.5, share});
  }
}

/// Half-way between the middles of any two edges. Where two strips end in a leaf, they may be one.
void SharpBends::append_between_edges(std::size_t number, std::vector<Place>& places) const {
  const std::span<const Triangle> triangles = leaves_[number].triangles;
  const auto is_on_edge = [this](std::uint32_t corner) {
    return tree_.vertices().is_on_feature(corner);
  };
  std::vector<dvec2> middles;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      if (!is_on_edge(a) || !is_on_edge(b) || has_side(triangles, b, a)) continue;
      const dvec2 middle = 0.5 * (grid_.mesh.uv[a] + grid_.mesh.uv[b]);
      for (const dvec2& other : middles) places.push_back({number, 0.5 * (middle + other)});
      middles.push_back(middle);
    }
  }
}

/// The middles of triangles' sides, each once.
void SharpBends::append_middles(std::size_t number, std::vector<Place>& places) const {
  const std::span<const Triangle> triangles = leaves_[number].triangles;
  const auto& uv = grid_.mesh.uv;
  for (const Triangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k];
      const std::uint32_t b = t[(k + 1) % 3];
      if (a > b && has_side(triangles, b, a)) continue;
      places.push_back({number, 0.5 * (uv[a] + uv[b]), std::array{a, b}});
    }
  }
}

void SharpBends::validate_at(const dvec2& uv, const dvec3& position, SharpLeaf& leaf,
                             ValidatedMesh& mesh) const {
  if (!is_seen(clip_, position)) return;
  const double distance = distance_from(grid_, leaf.triangles, uv, position, leaf.distance);
  if (!(distance > leaf.distance)) return;
  leaf.distance = distance;
  leaf.farthest = uv;
  mesh.add(leaf.number, distance, uv);
}

void SharpBends::sample(ValidatedMesh& mesh) {
  std::vector<Place> places;
  for (std::size_t k = 0; k < leaves_.size(); ++k) {
    if (leaves_[k].targets.places) append_places(k, places);
    if (leaves_[k].targets.in_strip) append_between_edges(k, places);
    if (leaves_[k].targets.sides) append_middles(k, places);
  }
  std::vector<dvec2> uv(places.size());
  std::ranges::transform(places, uv.begin(), &Place::uv);
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  evaluations_ += points.size();
  const Mesh& of = grid_.mesh;
  std::vector<MiddleOfChord> chords;
  std::vector<std::size_t> leaves;  // of those
  for (std::size_t k = 0; k < places.size(); ++k) {
    const auto& [number, at, side] = places[k];
    SharpLeaf& leaf = leaves_[number];
    const double allowed = mesh.allowed[leaf.number];
    if (!mesh.is_near(leaf.number)) continue;
    if (!side) {
      validate_at(at, points[k], leaf, mesh);
      continue;
    }
    const auto& [a, b] = *side;
    MiddleOfChord chord{{of.position[a], of.position[b]},
                        {of.uv[a], of.uv[b]},
                        glm::abs(leaf.high - leaf.low),
                        allowed};
    if (glm::distance(chord.middle(), points[k]) <= kLeastEstimate * allowed) continue;
    if (moves_by_last_digit(surface_, at, allowed)) continue;
    validate_at(at, points[k], leaf, mesh);
    chord.known = mesh.sampled_errors[leaf.number].distance;
    if (!mesh.is_near(leaf.number)) continue;
    chords.push_back(chord);
    leaves.push_back(leaf.number);
  }
  const std::vector<double> distances = distances_from_surface(surface_, chords, threads_);
  for (std::size_t k = 0; k < chords.size(); ++k) mesh.add(leaves[k], distances[k]);
}

/// Compass search from the farthest place of each leaf.
void SharpBends::search(ValidatedMesh& mesh) {
  std::vector<dvec2> uv;
  for (const double step : kStepShares) {
    std::erase_if(leaves_, [&](const SharpLeaf& leaf) {
      const double least = leaf.targets.in_strip ? kDoubtful : kLeastEstimate;
      return !mesh.is_near(leaf.number) || leaf.distance < least * mesh.allowed[leaf.number];
    });
    uv.clear();
    for (const SharpLeaf& leaf : leaves_) {
      for (const dvec2& way : kFourWays) {
        const dvec2 there = leaf.farthest + step * way * (leaf.high - leaf.low);
        uv.push_back(nearest_in({leaf.low, leaf.high}, there));
      }
    }
    const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
    evaluations_ += points.size();
    for (std::size_t k = 0; k < points.size(); ++k) {
      validate_at(uv[k], points[k], leaves_[k / kFourWays.size()], mesh);
    }
  }
}

/// Places on the sides that leave the surface at a corner. They are nearest to the corner, or to
/// the wall that the side leads down.
void SharpBends::append_below_corners(const Triangle& t, double allowed,
                                      std::vector<MeshPlace>& places) const {
  const Mesh& mesh = grid_.mesh;
  for (int k = 0; k < 3; ++k) {
    const std::uint32_t corner = t[static_cast<std::size_t>(k)];
    for (int other = (k + 1) % 3; other != k; other = (other + 1) % 3) {
      const dvec3 side = mesh.position[t[static_cast<std::size_t>(other)]] - mesh.position[corner];
      const double share = kBelowCorner * allowed / std::fabs(glm::dot(side, mesh.normal[corner]));
      if (!(share < 0.5)) continue;
      dvec3 weights(0);
      weights[k] = 1 - share;
      weights[other] = share;
      places.push_back({&t, weights});
    }
  }
}

/// Searches the surface near the triangles of bridged bends. Distances within the tolerance are not
/// added: a search ends there.
void SharpBends::measure_triangles(ValidatedMesh& mesh) {
  std::vector<MeshPlace> places;
  double least = std::numeric_limits<double>::infinity();
  for (const SharpLeaf& leaf : leaves_) {
    if (!leaf.targets.from_triangles || !mesh.is_near(leaf.number)) continue;
    least = std::min(least, mesh.allowed[leaf.number]);
    for (const Triangle& t : leaf.triangles) {
      const bool is_thick =
          thickness_of(grid_.mesh, t) > kDoubtfulSides * mesh.allowed[leaf.number];
      for (const dvec3& weights : kMiddlesOfTriangle) {
        if (is_thick) places.push_back({&t, weights});
      }
      append_below_corners(t, mesh.allowed[leaf.number], places);
    }
  }
  if (places.empty()) return;
  const WholeMeshError whole(surface_, grid_, {}, {}, threads_);
  for (const auto& [triangle, distance] :
       whole.farther_than(kDoubtfulSides * least, least, places)) {
    const auto is_before = [](const Triangle* t, const SharpLeaf& leaf) {
      return t < leaf.triangles.data();
    };
    const auto next = std::upper_bound(leaves_.begin(), leaves_.end(), triangle, is_before);
    const std::size_t number = std::prev(next)->number;
    if (distance > mesh.allowed[number]) mesh.add(number, distance);
  }
}

void SharpBends::measure(ValidatedMesh& mesh) {
  sample(mesh);
  measure_triangles(mesh);
  search(mesh);
}

}  // namespace saddle
