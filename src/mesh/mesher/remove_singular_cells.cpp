#include "mesh/mesher/remove_singular_cells.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>

#include <glm/common.hpp>

#include "base/parallel.h"
#include "mesh/features/approach.h"
#include "mesh/mesher/edge_features.h"
#include "mesh/mesher/follow_features.h"
#include "mesh/mesher/halving_limits.h"
#include "mesh/mesher/pole_features.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"
#include "surface/parameter_box.h"

namespace saddle {

namespace {

/// At most 4,096 leaves are searched for point singularities; most take one proof.
constexpr std::size_t kMostSingularities = 4096;

/// A box around a place, twice as large as `box`, within the domain.
ParameterBox box_around(const dvec2& place, const ParameterBox& box, const Domain& d) {
  const dvec2 size = box.high - box.low;
  const dvec2 first = glm::min(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  const dvec2 last = glm::max(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  return {glm::clamp(place - size, first, last), glm::clamp(place + size, first, last)};
}

/// Single points in leaves at which bounds do not prove the surface to be continuous.
struct PointsInLeaves {
  std::vector<dvec2> places;
  std::vector<std::size_t> leaves;  ///< their numbers
  /// Whether a point is the only one in a box around it: a leaf may touch a line of jumps in one
  /// point.
  std::vector<bool> are_alone;
};

PointsInLeaves find_points(const Surface& surface, const CellTree& tree, const ValidatedMesh& mesh,
                           std::span<const std::size_t> searched) {
  std::vector<ParameterBox> boxes;
  for (const std::size_t k : searched) {
    boxes.push_back(tree.box(mesh.leaves[k]));
  }
  const auto found = find_point_singularities(surface, boxes, tree.mesh().bounds.diagonal());
  PointsInLeaves points;
  std::vector<ParameterBox> around;
  for (std::size_t i = 0; i < searched.size(); ++i) {
    if (!found[i]) continue;
    points.places.push_back(*found[i]);
    points.leaves.push_back(searched[i]);
    around.push_back(box_around(*found[i], boxes[i], surface.domain));
  }
  for (const auto& place : find_point_singularities(surface, around)) {
    points.are_alone.push_back(place.has_value());
  }
  return points;
}

/// Whether the ways to a point have more limits than lines of jumps through it explain.
bool has_many_limits(const PointSingularity& singularity, double diagonal) {
  return singularity.around.count_chords(kNearly * diagonal) > kLimitsOfLines;
}

/// Whether the chords between corners are within tolerance of the limits at an essential point. The
/// limits may lie on a curve, which chords cut short.
bool are_chords_near(const PointSingularity& singularity, const std::array<dvec3, 4>& corners,
                     double allowed) {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      for (const double share : {0.25, 0.5, 0.75}) {
        const dvec3 place = glm::mix(corners[a], corners[b], share);
        if (is_finite(place) && !singularity.around.is_within(place, allowed)) return false;
      }
    }
  }
  return true;
}

/// Whether the known error of a leaf exceeds its tolerance.
bool exceeds_tolerance(const ValidatedMesh& mesh, std::size_t number) {
  return mesh.error_ratio(number) > 1 || mesh.leaves[number].known_error > 1;
}

/// The leaves that may hold a point singularity, up to 4,096, smallest first: those that exceed the
/// tolerance or took 14 halvings, and have no boundary.
std::vector<std::size_t> leaves_to_search(const CellLimits& limits, const CellTree& tree,
                                          const ValidatedMesh& mesh) {
  std::vector<std::size_t> searched;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    const bool is_deep = halvings_of_root(leaf) >= kMostCutHalvings;
    if (!leaf.state.is_on_boundary() && (exceeds_tolerance(mesh, k) || is_deep) &&
        !is_clipped(leaf, limits.clip, tree))
      searched.push_back(k);
  }
  const auto area = [&](std::size_t k) {
    const Leaf& leaf = mesh.leaves[k];
    return std::uint64_t{leaf.size_u()} * leaf.size_v();
  };
  std::ranges::stable_sort(searched, {}, area);
  if (searched.size() > kMostSingularities) searched.resize(kMostSingularities);
  return searched;
}

/// The corners of a square are sqrt(2) times as far away as its sides: a corner is near if each
/// coordinate is within this.
double near_each_way(double allowed) {
  return allowed / std::numbers::sqrt2;
}

/// Poles and essential points, indexed by the positions of the surface around them.
class SingularitiesInSpace {
 public:
  explicit SingularitiesInSpace(std::vector<const PointSingularity*> singularities)
      : singularities_(std::move(singularities)) {
    dvec3 widest(0);
    Bounds lows;
    for (const PointSingularity* const singularity : singularities_) {
      widest = glm::max(widest, singularity->near.size());
      lows.add(singularity->near.low);
    }
    // The axis that separates them best; along others, poles may extend to the largest double.
    const auto told_apart = [&](int axis) { return lows.size()[axis] / widest[axis]; };
    for (int axis = 1; axis < 3; ++axis) {
      if (told_apart(axis) > told_apart(axis_)) axis_ = axis;
    }
    widest_ = widest[axis_];
    std::ranges::stable_sort(singularities_, {}, [this](const PointSingularity* singularity) {
      return low(singularity);
    });
  }

  /// Calls f(singularity) for all that may be within `near` of a place.
  template <class F>
  void for_near(const dvec3& place, double near, F f) const {
    const auto first = std::ranges::lower_bound(
        singularities_, place[axis_] - near - widest_, {},
        [this](const PointSingularity* singularity) { return low(singularity); });
    for (auto singularity = first;
         singularity != singularities_.end() && low(*singularity) <= place[axis_] + near;
         ++singularity) {
      f(**singularity);
    }
  }

 private:
  double low(const PointSingularity* singularity) const { return singularity->near.low[axis_]; }

  std::vector<const PointSingularity*> singularities_;
  int axis_ = 0;
  double widest_ = 0;
};

/// Sets the errors of a leaf to 0 if its corners are within tolerance of the limits at a pole or an
/// essential point: they are near the surface then, wherever a validation point is. A leaf whose
/// chords are farther away is left out.
void accept_around(const PointSingularity& singularity, const std::array<dvec3, 4>& corners,
                   std::size_t number, ValidatedMesh& mesh) {
  const double near = near_each_way(mesh.allowed[number]);
  const Bounds around{singularity.near.low - near, singularity.near.high + near};
  const auto is_near = [&](const dvec3& p) { return !is_finite(p) || around.contains(p); };
  if (!std::ranges::all_of(corners, is_near)) return;
  Leaf& leaf = mesh.leaves[number];
  if (!singularity.around.empty()) {
    const auto exceeds_tolerance = [&](const dvec3& p) {
      return is_finite(p) && !singularity.around.is_within(p, mesh.allowed[number]);
    };
    if (std::ranges::any_of(corners, exceeds_tolerance)) return;
    if (!are_chords_near(singularity, corners, mesh.allowed[number])) leaf.state.leave_out();
  }
  mesh.sampled_errors[number] = {};
  leaf.known_error = 0;
}

void accept_around(std::vector<const PointSingularity*> singularities, const CellTree& tree,
                   ValidatedMesh& mesh) {
  std::erase_if(singularities, [](const PointSingularity* singularity) {
    return singularity->kind != PointSingularity::Kind::Essential &&
           singularity->kind != PointSingularity::Kind::Pole;
  });
  if (singularities.empty()) return;
  const SingularitiesInSpace in_space(std::move(singularities));
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const std::array<dvec3, 4> corners = corner_positions(mesh.leaves[k], tree);
    const auto* const known = std::ranges::find_if(corners, is_finite);
    if (known == corners.end()) continue;
    in_space.for_near(
        *known, near_each_way(mesh.allowed[k]),
        [&](const PointSingularity& singularity) { accept_around(singularity, corners, k, mesh); });
  }
}

/// Sides of leaves that are left in the mesh, sorted.
struct Sides {
  std::vector<Side> lead_to_poles;  ///< without an edge feature
  std::vector<Side> unsearched;     ///< may lead to poles
  std::vector<Side> cut;            ///< by an edge feature other than a pole
};

void append_classified(const Leaf& leaf, bool is_unproved, const CellTree& tree, Sides& sides) {
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const Side side = side_of(a, b);
    if (const auto feature = tree.edges().feature(a, b)) {
      if (!leaves_out(feature->kind)) sides.cut.push_back(side);
    } else if (tree.edges().leads_to_pole(a, b)) {
      sides.lead_to_poles.push_back(side);
    } else if (is_unproved && !tree.edges().is_searched(a, b)) {
      sides.unsearched.push_back(side);
    }
  });
}

/// Without a clip box, the tolerance is a share of the height of the surface, which has no end at a
/// pole. Walls may be within tolerance then, so all leaves of a surface with poles count.
Sides classify_sides(const CellLimits& limits, const CellTree& tree, const ValidatedMesh& mesh) {
  const bool has_poles = tree.has_poles();
  const std::vector<Sides> parts = results_of_chunks(
      mesh.leaves.size(), kInBatch, limits.threads, [&](std::size_t begin, std::size_t end) {
        Sides part;
        for (std::size_t k = begin; k < end; ++k) {
          const Leaf& leaf = mesh.leaves[k];
          const bool is_unproved = exceeds_tolerance(mesh, k) || (has_poles && !limits.clip);
          if (!is_unproved && !has_poles) continue;
          if (leaf.state.is_left_out() || is_clipped(leaf, limits.clip, tree)) continue;
          append_classified(leaf, is_unproved, tree, part);
        }
        return part;
      });
  Sides result;
  for (const auto kind : {&Sides::lead_to_poles, &Sides::unsearched, &Sides::cut}) {
    std::vector<Side>& sides = result.*kind;
    for (const Sides& part : parts)
      sides.insert(sides.end(), (part.*kind).begin(), (part.*kind).end());
    sort_sides(sides);
  }
  return result;
}

/// Vertices of failed leaves that are on poles: rounding made their positions finite.
std::set<std::uint32_t> vertices_on_poles(const CellLimits& limits, const CellTree& tree,
                                          const ValidatedMesh& mesh) {
  std::vector<Line> ways;
  std::vector<std::uint32_t> vertices;
  double delta = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    if (leaf.state.is_left_out() || !exceeds_tolerance(mesh, k)) continue;
    delta = std::min(delta, mesh.allowed[k]);
    for (std::size_t c = 0; c < 4; ++c) {
      vertices.push_back(leaf.samples.corner[c]);
      const std::uint32_t across = leaf.samples.corner[(c + 2) % 4];
      ways.push_back({tree.mesh().uv[vertices.back()], tree.mesh().uv[across]});
    }
  }
  const std::vector<bool> on_pole = diverge(tree.surface(), ways, delta, limits.threads);
  std::set<std::uint32_t> result;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (on_pole[k]) result.insert(vertices[k]);
  }
  return result;
}

/// Leaves out the needles to vertices on poles, which no box clips.
void leave_out_needles(const CellLimits& limits, const CellTree& tree, ValidatedMesh& mesh) {
  const std::set<std::uint32_t> on_poles = vertices_on_poles(limits, tree, mesh);
  if (on_poles.empty()) return;
  for (Leaf& leaf : mesh.leaves) {
    for_sides(leaf, tree, [&](std::uint32_t vertex, std::uint32_t) {
      if (on_poles.contains(vertex)) leaf.state.leave_out();
    });
  }
}

}  // namespace

bool is_clipped(const Leaf& leaf, const std::optional<Bounds>& clip, const CellTree& tree) {
  if (!clip || !is_beyond(*clip, corner_positions(leaf, tree))) return false;
  // On its way to a pole the surface may cross the box between corners beyond one face, and beside
  // a jump it may be in it. Its cuts are in the box then.
  const auto& position = tree.mesh().position;
  bool is_seen = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<EdgeFeature> cut = tree.edges().feature(a, b);
    if (!cut || (cut->kind != FeatureKind::Face && cut->kind != FeatureKind::Jump)) return;
    is_seen = is_seen || clip->contains(position[cut->beside_first]) ||
              clip->contains(position[cut->beside_second]);
  });
  return !is_seen;
}

std::vector<PlacedSingularity> leave_out_singularities(const Surface& surface,
                                                       const CellLimits& limits,
                                                       const CellTree& tree, ValidatedMesh& mesh) {
  const auto [places, leaves, are_alone] =
      find_points(surface, tree, mesh, leaves_to_search(limits, tree, mesh));
  const double diagonal = tree.mesh().bounds.diagonal();
  const std::vector<PointSingularity> singularities =
      classify_points(surface, places, diagonal, limits.threads);
  const Domain& d = surface.domain;
  const dvec2 range = glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
  std::vector<PlacedSingularity> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool has_no_limit = singularities[i].kind == PointSingularity::Kind::Essential &&
                              (are_alone[i] || has_many_limits(singularities[i], diagonal));
    if (!has_no_limit && singularities[i].kind != PointSingularity::Kind::Pole) continue;
    mesh.leaves[leaves[i]].state.leave_out();
    const auto is_same = [&, place = places[i]](const PlacedSingularity& other) {
      const dvec2 off = glm::abs(other.uv - place) / range;
      return std::max(off.x, off.y) < kSame;
    };
    if (std::ranges::none_of(result, is_same)) result.push_back({places[i], singularities[i]});
  }
  std::vector<const PointSingularity*> to_accept;
  to_accept.reserve(result.size() + tree.geometry().singularities().size());
  for (const PlacedSingularity& placed : result) to_accept.push_back(&placed.singularity);
  for (const auto& [vertex, singularity] : tree.geometry().singularities())
    to_accept.push_back(&singularity);
  accept_around(std::move(to_accept), tree, mesh);
  return result;
}

void cut_walls(const CellLimits& limits, bool search, CellTree& tree, ValidatedMesh& mesh) {
  const TraceOptions with_poles{limits.tolerance, true, limits.threads, limits.clip,
                                limits.triangles};
  if (!limits.clip && tree.has_poles()) leave_out_needles(limits, tree, mesh);
  Sides sides = classify_sides(limits, tree, mesh);
  cut_poles(sides.lead_to_poles, with_poles, tree);
  if (search) find_jumps(sides.unsearched, with_poles, tree);
  follow_features(with_poles, mesh.leaves, tree);
  if (!search || !tree.has_poles()) return;
  for (const auto& [a, b] : sides.unsearched) {
    const auto feature = tree.edges().feature(a, b);
    if (feature && !leaves_out(feature->kind)) sides.cut.push_back({a, b});
  }
  find_poles_beside_cuts(sides.cut, with_poles, tree);
}

}  // namespace saddle
