#include "mesh/mesher/cut_out.h"

#include <algorithm>
#include <limits>
#include <set>

#include <glm/common.hpp>

#include "mesh/features/approach.h"
#include "mesh/model/clip.h"

namespace saddle {

namespace {

/// Leaves in which points that are no part of the surface are looked for, at most: most take one
/// proof.
constexpr std::size_t kMostHoles = 4096;
/// The area of a leaf, in units, after 14 halvings of its root cell.
constexpr std::uint64_t kDeepLeaf = std::uint64_t{kCellUnit} * kCellUnit >> 14U;
/// How near to each other, in ranges, points are one.
constexpr double kSamePlace = 1e-9;
/// Limits that are this near to each other, in diagonals, are one; and so many are where the ways
/// to a point cross sixteen lines of jumps, no more.
constexpr double kSameLimit = 1e-6;
constexpr std::size_t kLimitsOfLines = 32;
/// How near each coordinate of a corner must be for it, in what is allowed: a square's corners are
/// 1.41 times as far away as its sides.
constexpr double kNearHole = 0.7;

/// What is around a place in a box, as far as the box goes on either side of it, in the domain.
ParameterBox box_around(const dvec2& place, const ParameterBox& box, const Domain& d) {
  const dvec2 size = box.high - box.low;
  const dvec2 first = glm::min(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  const dvec2 last = glm::max(dvec2(d.u0, d.v0), dvec2(d.u1, d.v1));
  return {glm::clamp(place - size, first, last), glm::clamp(place + size, first, last)};
}

/// Single points in leaves where bounds leave room for a break.
struct PointsInLeaves {
  std::vector<dvec2> places;
  std::vector<std::size_t> leaves;  ///< their numbers
  /// Whether there is no room around a point either: a leaf may touch a line of jumps in one point.
  std::vector<bool> are_alone;
};

PointsInLeaves find_points(const Surface& surface, const Lattice& lattice, const Measured& mesh,
                           std::span<const std::size_t> suspects) {
  std::vector<ParameterBox> boxes;
  for (const std::size_t k : suspects) {
    const Leaf& leaf = mesh.leaves[k];
    boxes.push_back({lattice.parameters(leaf.low), lattice.parameters(leaf.high)});
  }
  const auto found = find_holes(surface, boxes, lattice.mesh().bounds.diagonal());
  PointsInLeaves points;
  std::vector<ParameterBox> around;
  for (std::size_t i = 0; i < suspects.size(); ++i) {
    if (!found[i]) continue;
    points.places.push_back(*found[i]);
    points.leaves.push_back(suspects[i]);
    around.push_back(box_around(*found[i], boxes[i], surface.domain));
  }
  for (const auto& place : find_holes(surface, around)) {
    points.are_alone.push_back(place.has_value());
  }
  return points;
}

/// Whether a point that is not alone has no limit: along a line of jumps, ways lead to few places.
bool has_many_limits(const Hole& hole, double diagonal) {
  return hole.around.count_chords(kSameLimit * diagonal) > kLimitsOfLines;
}

/// Whether chords between corners keep to the places to which ways to a point lead: they may be a
/// curve, which chords cut short.
bool is_along(const Hole& hole, const std::array<dvec3, 4>& corners, double allowed) {
  for (std::size_t a = 0; a < 4; ++a) {
    for (std::size_t b = a + 1; b < 4; ++b) {
      for (const double share : {0.25, 0.5, 0.75}) {
        const dvec3 place = glm::mix(corners[a], corners[b], share);
        if (is_finite(place) && !hole.around.is_within(place, allowed)) return false;
      }
    }
  }
  return true;
}

/// Whether halving did not help a leaf.
bool is_off(const Measured& mesh, std::size_t number) {
  const Leaf& leaf = mesh.leaves[number];
  return mesh.off(number) > 1 || (leaf.given_up && leaf.known_error > 1);
}

/// The smallest of the leaves that halving did not help, or that took many halvings: a leaf that
/// is no larger than the tolerance is right, whatever is in it.
std::vector<std::size_t> leaves_with_holes(const RefineOptions& options, const Lattice& lattice,
                                           const Measured& mesh) {
  std::vector<std::size_t> suspects;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    const bool is_deep = std::uint64_t{leaf.size_u()} * leaf.size_v() <= kDeepLeaf;
    if (!leaf.on_rim && (is_off(mesh, k) || is_deep) && !is_clipped(leaf, options.clip, lattice))
      suspects.push_back(k);
  }
  const auto area = [&](std::size_t k) {
    const Leaf& leaf = mesh.leaves[k];
    return std::uint64_t{leaf.size_u()} * leaf.size_v();
  };
  std::ranges::stable_sort(suspects, {}, area);
  if (suspects.size() > kMostHoles) suspects.resize(kMostHoles);
  return suspects;
}

/// Points that are poles or have no limit, by where the surface is around them.
class HolesInSpace {
 public:
  explicit HolesInSpace(std::vector<const Hole*> holes) : holes_(std::move(holes)) {
    dvec3 widest(0);
    Bounds lows;
    for (const Hole* const hole : holes_) {
      widest = glm::max(widest, hole->near.size());
      lows.add(hole->near.low);
    }
    // The axis along which they are best told apart; poles are as long as doubles go along others.
    const auto told_apart = [&](int axis) { return lows.size()[axis] / widest[axis]; };
    for (int axis = 1; axis < 3; ++axis) {
      if (told_apart(axis) > told_apart(axis_)) axis_ = axis;
    }
    widest_ = widest[axis_];
    std::ranges::stable_sort(holes_, {}, [this](const Hole* hole) { return low(hole); });
  }

  /// Calls f(hole) for all that a place may be near to.
  template <class F>
  void for_near(const dvec3& place, double near, F f) const {
    const auto first = std::ranges::lower_bound(holes_, place[axis_] - near - widest_, {},
                                                [this](const Hole* hole) { return low(hole); });
    for (auto hole = first; hole != holes_.end() && low(*hole) <= place[axis_] + near; ++hole) {
      f(**hole);
    }
  }

 private:
  double low(const Hole* hole) const { return hole->near.low[axis_]; }

  std::vector<const Hole*> holes_;
  int axis_ = 0;
  double widest_ = 0;
};

/// Ways to a point that is a pole or has no limit lead to all places around which it is: what is
/// nearer to them than is allowed is near enough to the surface, whichever part of it is measured.
void accept_around(const Hole& hole, const std::array<dvec3, 4>& corners, std::size_t number,
                   Measured& mesh) {
  const double near = kNearHole * mesh.allowed[number];
  const Bounds around{hole.near.low - near, hole.near.high + near};
  const auto is_near = [&](const dvec3& p) { return !is_finite(p) || around.contains(p); };
  if (!std::ranges::all_of(corners, is_near)) return;
  Leaf& leaf = mesh.leaves[number];
  if (!hole.around.empty()) {
    const auto is_off = [&](const dvec3& p) {
      return is_finite(p) && !hole.around.is_within(p, mesh.allowed[number]);
    };
    if (std::ranges::any_of(corners, is_off)) return;
    if (!is_along(hole, corners, mesh.allowed[number])) leaf.is_left_out = true;
  }
  mesh.deviations[number] = {};
  leaf.known_error = 0;
}

void accept_around(std::vector<const Hole*> holes, const Lattice& lattice, Measured& mesh) {
  std::erase_if(holes, [](const Hole* hole) {
    return hole->kind != Hole::Kind::NoLimit && hole->kind != Hole::Kind::Pole;
  });
  if (holes.empty()) return;
  const HolesInSpace in_space(std::move(holes));
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const std::array<dvec3, 4> corners = corner_positions(mesh.leaves[k], lattice);
    const auto* const known = std::ranges::find_if(corners, is_finite);
    if (known == corners.end()) continue;
    in_space.for_near(*known, kNearHole * mesh.allowed[k],
                      [&](const Hole& hole) { accept_around(hole, corners, k, mesh); });
  }
}

/// Sides of leaves of which something is left, in the order of their numbers.
struct Sides {
  std::vector<Side> lead_to_poles;  ///< and are not cut
  std::vector<Side> unsearched;     ///< that may lead there
  std::vector<Side> cut;            ///< by what is no pole
};

/// A wall need not be far off: where nothing clips a surface that goes to infinity, tolerances are
/// a share of its height without end, and all sides of leaves may lead to poles.
Sides classify_sides(const RefineOptions& options, const Lattice& lattice, const Measured& mesh) {
  Sides result;
  const bool has_poles = lattice.has_poles();
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    const bool is_suspect = is_off(mesh, k) || (has_poles && !options.clip);
    if (!is_suspect && !has_poles) continue;
    if (leaf.is_left_out || is_clipped(leaf, options.clip, lattice)) continue;
    for_sides(leaf, lattice, [&](std::uint32_t a, std::uint32_t b) {
      const Side side = {std::min(a, b), std::max(a, b)};
      if (const auto crossing = lattice.crossing(a, b)) {
        if (!leaves_out(crossing->kind)) result.cut.push_back(side);
      } else if (lattice.leads_to_pole(a, b)) {
        result.lead_to_poles.push_back(side);
      } else if (is_suspect && !lattice.is_searched(a, b)) {
        result.unsearched.push_back(side);
      }
    });
  }
  for (std::vector<Side>* const sides : {&result.lead_to_poles, &result.unsearched, &result.cut}) {
    std::ranges::sort(*sides);
    sides->erase(std::unique(sides->begin(), sides->end()), sides->end());
  }
  return result;
}

/// Vertices that are on poles, at a finite place by rounding alone, of leaves that are off.
std::set<std::uint32_t> vertices_on_poles(const RefineOptions& options, const Lattice& lattice,
                                          const Measured& mesh) {
  std::vector<Line> ways;
  std::vector<std::uint32_t> vertices;
  double delta = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    if (leaf.is_left_out || !is_off(mesh, k)) continue;
    delta = std::min(delta, mesh.allowed[k]);
    for (std::size_t c = 0; c < 4; ++c) {
      vertices.push_back(leaf.samples.corner[c]);
      const std::uint32_t across = leaf.samples.corner[(c + 2) % 4];
      ways.push_back({lattice.mesh().uv[vertices.back()], lattice.mesh().uv[across]});
    }
  }
  const std::vector<bool> on_pole = diverge(lattice.surface(), ways, delta, options.threads);
  std::set<std::uint32_t> result;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (on_pole[k]) result.insert(vertices[k]);
  }
  return result;
}

/// Nothing clips the needles to such vertices.
void leave_out_needles(const RefineOptions& options, const Lattice& lattice, Measured& mesh) {
  const std::set<std::uint32_t> on_poles = vertices_on_poles(options, lattice, mesh);
  if (on_poles.empty()) return;
  for (Leaf& leaf : mesh.leaves) {
    for_sides(leaf, lattice, [&](std::uint32_t vertex, std::uint32_t) {
      leaf.is_left_out = leaf.is_left_out || on_poles.contains(vertex);
    });
  }
}

}  // namespace

bool is_clipped(const Leaf& leaf, const std::optional<Bounds>& clip, const Lattice& lattice) {
  return clip && is_beyond(*clip, corner_positions(leaf, lattice));
}

std::vector<PlacedHole> leave_out_holes(const Surface& surface, const RefineOptions& options,
                                        const Lattice& lattice, Measured& mesh) {
  const auto [places, leaves, are_alone] =
      find_points(surface, lattice, mesh, leaves_with_holes(options, lattice, mesh));
  const double diagonal = lattice.mesh().bounds.diagonal();
  const std::vector<Hole> holes = look_at_holes(surface, places, diagonal, options.threads);
  const Domain& d = surface.domain;
  const dvec2 range = glm::abs(dvec2(d.u1 - d.u0, d.v1 - d.v0));
  std::vector<PlacedHole> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_torn = holes[i].kind == Hole::Kind::NoLimit &&
                         (are_alone[i] || has_many_limits(holes[i], diagonal));
    if (!is_torn && holes[i].kind != Hole::Kind::Pole) continue;
    mesh.leaves[leaves[i]].is_left_out = true;
    const auto is_same = [&, place = places[i]](const PlacedHole& other) {
      const dvec2 off = glm::abs(other.uv - place) / range;
      return std::max(off.x, off.y) < kSamePlace;
    };
    if (std::ranges::none_of(result, is_same)) result.push_back({places[i], holes[i]});
  }
  std::vector<const Hole*> to_accept;
  to_accept.reserve(result.size() + lattice.holes().size());
  for (const PlacedHole& placed : result) to_accept.push_back(&placed.hole);
  for (const auto& [vertex, hole] : lattice.holes()) to_accept.push_back(&hole);
  accept_around(std::move(to_accept), lattice, mesh);
  return result;
}

void cut_walls(const RefineOptions& options, bool search, Lattice& lattice, Measured& mesh) {
  const CrossingOptions with_poles{options.tolerance, true, options.threads, options.clip,
                                   options.max_triangles};
  if (!options.clip && lattice.has_poles()) leave_out_needles(options, lattice, mesh);
  Sides sides = classify_sides(options, lattice, mesh);
  cut_poles(sides.lead_to_poles, with_poles, lattice);
  if (search) find_jumps(sides.unsearched, with_poles, lattice);
  follow_crossings(with_poles, mesh.leaves, lattice);
  if (!search || !lattice.has_poles()) return;
  for (const auto& [a, b] : sides.unsearched) {
    const auto crossing = lattice.crossing(a, b);
    if (crossing && !leaves_out(crossing->kind)) sides.cut.push_back({a, b});
  }
  find_poles_beside_cuts(sides.cut, with_poles, lattice);
}

}  // namespace saddle
