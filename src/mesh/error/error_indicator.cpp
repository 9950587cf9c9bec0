#include "mesh/error/error_indicator.h"

#include <cmath>
#include <numbers>
#include <optional>
#include <span>

#include <glm/common.hpp>

#include "base/numbers.h"
#include "mesh/distance/chord_error.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/grid/triangulate.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/model/clip.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/leaf_border.h"

namespace saddle {

namespace {

/// The ball around the first of some points that holds the others. Points that are not finite are
/// skipped.
class Ball {
 public:
  void add(const dvec3& p) {
    if (!std::isfinite(p.x + p.y + p.z)) return;
    if (!centre_) centre_ = p;
    reach_ = std::max(reach_, glm::distance(*centre_, p));
  }
  double allowed_by(const Tolerance& tolerance) const {
    return centre_ ? tolerance(*centre_, reach_) : tolerance(dvec3(0), kInfinity);
  }

 private:
  std::optional<dvec3> centre_;
  double reach_ = 0;
};

/// The longer side of the pair of opposite sides that is shorter.
double narrow_side(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner) {
  const auto length = [&](std::size_t a, std::size_t b) {
    return glm::distance(mesh.position[corner[a]], mesh.position[corner[b]]);
  };
  return std::min(std::max(length(0, 1), length(2, 3)), std::max(length(1, 2), length(3, 0)));
}

}  // namespace

ErrorIndicator::ErrorIndicator(const CellLimits& limits, const Grid& grid, const CellTree& tree)
    : limits_(limits), grid_(grid), mesh_(grid.mesh), tree_(tree) {
  if (!limits.clip) return;
  const double margin = grid.mesh.bounds.diagonal();
  far_ = Bounds{limits.clip->low - margin, limits.clip->high + margin};
}

bool ErrorIndicator::is_regular(std::uint32_t vertex) const {
  return tree_.geometry().is_regular(vertex);
}

/// A chord and the sample above it.
struct ErrorIndicator::ChordSample {
  ChordSample(const dvec3& first, const dvec3& last, const dvec3& sample)
      : chord(last - first),
        off(sample - 0.5 * (first + last)),
        square(glm::dot(chord, chord)),
        distance_of_middle(glm::length(off)),
        is_small_arc(distance_of_middle <= kSmallArc * std::sqrt(square)) {}

  dvec3 chord;
  dvec3 off;      ///< from the chord's middle to the sample
  double square;  ///< of the chord's length
  double distance_of_middle;
  bool is_small_arc;

  /// The sample's foot on the chord: 0 at its middle, -0.5 and 0.5 at its ends.
  double from_middle() const { return square > 0 ? glm::dot(off, chord) / square : 0; }
  /// The distances of the sample from the chord and from the chord's line.
  double distance() const {
    return glm::length(off - std::clamp(from_middle(), -0.5, 0.5) * chord);
  }
  double distance_of_line() const { return glm::length(off - from_middle() * chord); }
};

void request_samples(Leaf& leaf, CellTree& tree) {
  auto& [corner, side, centre] = leaf.samples;
  const auto ask = [&](std::uint32_t& vertex, DyadicPoint place) {
    if (vertex == SampleVertices::kUnasked) vertex = tree.vertices().vertex(place);
  };
  const DyadicPoint m = leaf.middle();
  const auto& [low, high] = std::pair(leaf.low, leaf.high());
  const auto corners = leaf.corners();
  for (std::size_t k = 0; k < 4; ++k) ask(corner[k], corners[k]);
  ask(side[0], {m.u, low.v});
  ask(side[1], {high.u, m.v});
  ask(side[2], {m.u, high.v});
  ask(side[3], {low.u, m.v});
  ask(centre, m);
}

double tolerance_of(const Leaf& leaf, const Tolerance& tolerance, const CellTree& tree) {
  if (tolerance.is_same_everywhere()) return tolerance(dvec3(0));
  Ball ball;
  for (const std::uint32_t corner : leaf.samples.corner) ball.add(tree.mesh().position[corner]);
  return ball.allowed_by(tolerance);
}

double thickness(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner) {
  const auto& p = mesh.position;
  const dvec3 first = p[corner[2]] - p[corner[0]];
  const dvec3 second = p[corner[3]] - p[corner[1]];
  double longest = 0;
  for (std::size_t k = 0; k < 4; ++k)
    longest = std::max(longest, glm::distance(p[corner[k]], p[corner[(k + 1) % 4]]));
  return longest > 0 ? glm::length(glm::cross(first, second)) / 2 / longest : 0;
}

int count_defined(const CellTree& tree, const Leaf& leaf) {
  const SampleVertices& samples = leaf.samples;
  int count = tree.geometry().is_defined(samples.centre) ? 1 : 0;
  for (std::size_t k = 0; k < 4; ++k) {
    count += tree.geometry().is_defined(samples.corner[k]) ? 1 : 0;
    count += tree.geometry().is_defined(samples.side[k]) ? 1 : 0;
  }
  return count;
}

/// The largest height of the surface above the inside of the leaf's two triangles.
double ErrorIndicator::bulge_of_triangles(const SampleVertices& samples, std::size_t first) const {
  const auto& [corner, side, centre] = samples;
  const auto is_far = [&](std::uint32_t vertex) {
    return far_ && !far_->contains(mesh_.position[vertex]);
  };
  if (!is_regular(centre) || is_far(centre) || std::ranges::any_of(corner, is_far)) return 0;
  const dvec3& normal = mesh_.normal[centre];
  const auto height = [&](std::uint32_t a, std::uint32_t b, std::uint32_t sample) {
    const dvec3 middle = 0.5 * (mesh_.position[a] + mesh_.position[b]);
    return glm::dot(mesh_.position[sample] - middle, normal);
  };
  std::array<double, 4> sides{};
  for (std::size_t k = 0; k < 4; ++k) sides[k] = height(corner[k], corner[(k + 1) % 4], side[k]);
  const double diagonal = height(corner[first], corner[first + 2], centre);
  return std::max(bulge(sides[first], sides[first + 1], diagonal),
                  bulge(sides[first + 2], sides[(first + 3) % 4], diagonal));
}

/// The distance of a leaf's centre from its two triangles, cut from corner `first`: at an upright
/// front the diagonal may be far. That sticks out of a twisted leaf, where its height counts.
double ErrorIndicator::distance_from_triangles(const Leaf& leaf, std::size_t first,
                                               const ChordSample& diagonal) const {
  const auto& [corner, side, centre] = leaf.samples;
  const auto at = [&](std::size_t k) { return corner[(first + k) % 4]; };
  const std::array triangles = {Triangle{at(0), at(1), at(2)}, Triangle{at(2), at(3), at(0)}};
  const auto& n = mesh_.normal;
  const double least = std::min(glm::dot(n[at(0)], n[at(2)]), glm::dot(n[at(1)], n[at(3)]));
  const dvec3 normal = is_regular(centre) && least < kSteepCosine ? n[centre] : dvec3(0);
  return std::max(std::fabs(glm::dot(diagonal.off, normal)),
                  distance_from(grid_, triangles, mesh_.uv[centre], mesh_.position[centre]));
}

CellError ErrorIndicator::estimate(const Leaf& leaf) const {
  const auto& [corner, side, centre] = leaf.samples;
  const double eps = allowed(leaf);
  const double seen_turn = kSeenTurn * eps;
  const bool is_wide = narrow_side(mesh_, corner) > seen_turn;
  const bool is_opposed = has_opposed(leaf.samples);
  // A tip between opposed normals may stick out of a sliver.
  const bool is_sliver = is_wide && !is_opposed && !(thickness(mesh_, corner) > seen_turn);
  const bool is_visible = diameter(corner) > seen_turn;
  const std::size_t first_corner = first_of_diagonal(corner);  // of the diagonal
  CellError error;
  ErrorRatios turn;  // squares of tangents
  const auto add_chord = [&](std::uint32_t a, std::uint32_t b, std::uint32_t sample, bool border,
                             double ErrorRatios::*part) {
    const dvec3 first = seen_position(a);
    const dvec3 last = seen_position(b);
    const ChordSample arc(first, last, seen_position(sample));
    double distance = distance_of_sample(arc, {a, b, sample}, border) / eps;
    if (part == &ErrorRatios::centre && !is_opposed && !arc.is_small_arc && distance > 1) {
      distance = std::min(distance, distance_from_triangles(leaf, first_corner, arc) / eps);
    }
    error.distance.*part = std::max(error.distance.*part, distance);
    const double gap = arc.is_small_arc ? distance : arc.distance_of_middle / eps;
    error.gap.*part = std::max(error.gap.*part, gap);
    error.may_jump = error.may_jump || (is_visible && !arc.is_small_arc);
    const bool is_seen =
        part == &ErrorRatios::centre ? is_wide : arc.square > seen_turn * seen_turn;
    if (is_seen && !is_sliver) {
      turn.*part = std::max(turn.*part, square_of_tangent(a, b, sample));
    }
  };
  for (std::size_t k = 0; k < 4; ++k) {
    if (tree_.vertices().is_used(side[k])) continue;  // the halves are the mesh's edges
    add_chord(corner[k], corner[(k + 1) % 4], side[k], is_seen(leaf, k),
              k % 2 == 0 ? &ErrorRatios::along_u : &ErrorRatios::along_v);
  }
  add_chord(corner[first_corner], corner[first_corner + 2], centre, false, &ErrorRatios::centre);
  error.distance.centre =
      std::max(error.distance.centre, bulge_of_triangles(leaf.samples, first_corner) / eps);
  error.turn = turn_ratios(turn);
  error.is_folded = is_visible && is_opposed;
  return error;
}

ErrorRatios ErrorIndicator::turn_ratios(const ErrorRatios& squares) const {
  return {turn_ratio(squares.along_u), turn_ratio(squares.along_v), turn_ratio(squares.centre)};
}

double ErrorIndicator::allowed(const Leaf& leaf) const {
  if (limits_.tolerance.is_same_everywhere()) return limits_.tolerance(dvec3(0));
  const SampleVertices& samples = leaf.samples;
  Ball ball;
  ball.add(mesh_.position[samples.centre]);
  for (std::size_t k = 0; k < 4; ++k) {
    ball.add(mesh_.position[samples.corner[k]]);
    ball.add(mesh_.position[samples.side[k]]);
  }
  return ball.allowed_by(limits_.tolerance);
}

/// The middle of a side of a leaf and its chord.
struct ErrorIndicator::SideSample {
  double length;  ///< of the way through the middle
  double off;     ///< the distance of the middle from that of the chord
};

ErrorIndicator::SideSample ErrorIndicator::side(const Leaf& leaf, std::size_t k) const {
  const dvec3& a = mesh_.position[leaf.samples.corner[k]];
  const dvec3& b = mesh_.position[leaf.samples.corner[(k + 1) % 4]];
  const dvec3& middle = mesh_.position[leaf.samples.side[k]];
  return {glm::distance(a, middle) + glm::distance(middle, b),
          glm::distance(middle, 0.5 * (a + b))};
}

bool ErrorIndicator::splits_u(const Leaf& leaf, const Counterexample& counterexample) const {
  // Beside a vertical tangent bounds of the bend have no end: a leaf is not halved along an axis
  // along which it is shorter than the tolerance, where it is off along the other.
  const double eps = allowed(leaf);
  const auto is_short = [&](std::size_t k) {
    return std::max(side(leaf, k).length, side(leaf, k + 2).length) <= eps;
  };
  const auto is_off = [&](std::size_t k) {
    return std::max(side(leaf, k).off, side(leaf, k + 2).off) > eps;
  };
  for (const std::size_t axis : {0, 1}) {
    if (is_short(axis) && is_off(1 - axis)) return axis == 1;
  }
  const dvec2 size =
      tree_.vertices().parameters(leaf.high()) - tree_.vertices().parameters(leaf.low);
  const dvec2 arc = size * size * counterexample.bend;
  return arc.x == arc.y || !std::isfinite(arc.x + arc.y) ? splits_u(leaf, ErrorRatios())
                                                         : arc.x > arc.y;
}

bool ErrorIndicator::splits_u(const Leaf& leaf, const ErrorRatios& ratios) const {
  constexpr double kStraight = 0.1;  // as sides of a twisted leaf: the longer ones are halved
  if (std::max(ratios.along_u, ratios.along_v) > kStraight * ratios.centre) {
    return ratios.along_u >= ratios.along_v;
  }
  const auto length = [&](std::size_t a, std::size_t b) {
    const auto& corner = leaf.samples.corner;
    return glm::distance(mesh_.position[corner[a]], mesh_.position[corner[b]]);
  };
  return length(0, 1) + length(3, 2) >= length(0, 3) + length(1, 2);
}

bool ErrorIndicator::splits_boundary_u(const Leaf& leaf) const {
  const auto& [corner, side, centre] = leaf.samples;
  const auto changes = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return (tree_.geometry().is_defined(a) != tree_.geometry().is_defined(b) ? 1 : 0) +
           (tree_.geometry().is_defined(b) != tree_.geometry().is_defined(c) ? 1 : 0);
  };
  const int along_u = changes(corner[0], side[0], corner[1]) + changes(side[3], centre, side[1]) +
                      changes(corner[3], side[2], corner[2]);
  const int along_v = changes(corner[0], side[3], corner[3]) + changes(side[0], centre, side[2]) +
                      changes(corner[1], side[1], corner[2]);
  const auto [u, v] = std::pair(leaf.size_u(), leaf.size_v());
  // The error of a slender one is that of a chord, not of the boundary's place.
  const bool is_slender = std::max(u, v) > kSlender * std::min(u, v);
  return along_u == along_v || is_slender ? u >= v : along_u > along_v;
}

ErrorIndicator::Positions ErrorIndicator::defined_positions(const SampleVertices& samples) const {
  Positions positions;
  const auto add = [&](std::uint32_t vertex) {
    if (tree_.geometry().is_defined(vertex))
      positions.all[positions.count++] = mesh_.position[vertex];
  };
  for (std::size_t k = 0; k < 4; ++k) {
    add(samples.corner[k]);
    add(samples.side[k]);
  }
  add(samples.centre);
  return positions;
}

bool ErrorIndicator::is_clipped(const Leaf& leaf) const {
  return limits_.clip && is_beyond(*limits_.clip, defined_positions(leaf.samples).span());
}

bool ErrorIndicator::is_outside(const Leaf& leaf) const {
  if (!limits_.clip) return false;
  const Positions positions = defined_positions(leaf.samples);
  return std::ranges::all_of(positions.span(), [&](const dvec3& position) {
    return is_beyond(*limits_.clip, std::span(&position, 1));
  });
}

double ErrorIndicator::diameter(const Corners& corner) const {
  const auto& p = mesh_.position;
  return std::max(glm::distance(p[corner[0]], p[corner[2]]),
                  glm::distance(p[corner[1]], p[corner[3]]));
}

bool ErrorIndicator::is_too_small_to_see(const Leaf& leaf) const {
  const std::optional<double> border = border_of_pieces(leaf, tree_);
  return border && *border <= 2 * allowed(leaf);
}

bool ErrorIndicator::is_seen(const Leaf& leaf, std::size_t side) const {
  const auto is_among = [](std::uint32_t place, std::span<const std::uint8_t> lines) {
    return place % kCellUnit == 0 && lines[place / kCellUnit] != 0;
  };
  switch (side) {
    case 0:
      return is_among(leaf.low.v, limits_.seen_v);
    case 1:
      return is_among(leaf.high().u, limits_.seen_u);
    case 2:
      return is_among(leaf.high().v, limits_.seen_v);
    default:
      return is_among(leaf.low.u, limits_.seen_u);
  }
}

/// Whether the normals of two neighbouring regular samples are over 90 degrees apart. From corner
/// to corner, a smooth surface may turn as much.
bool ErrorIndicator::has_opposed(const SampleVertices& samples) const {
  const auto& n = mesh_.normal;
  const auto is_opposed = [&](std::uint32_t a, std::uint32_t middle, std::uint32_t b) {
    if (!is_regular(middle)) return glm::dot(n[a], n[b]) < 0;
    return glm::dot(n[a], n[middle]) < 0 || glm::dot(n[middle], n[b]) < 0;
  };
  const auto& [corner, side, centre] = samples;
  for (std::size_t k = 0; k < 4; ++k) {
    if (is_opposed(corner[k], side[k], corner[(k + 1) % 4])) return true;
  }
  return is_opposed(side[0], centre, side[2]) || is_opposed(side[1], centre, side[3]);
}

/// The position, clamped to the clip box and its margin.
dvec3 ErrorIndicator::seen_position(std::uint32_t vertex) const {
  const dvec3& p = mesh_.position[vertex];
  return far_ ? glm::clamp(p, far_->low, far_->high) : p;
}

/// The distance of a sample from the chord of a and b, an edge of the mesh. It is taken along the
/// normal, since triangles continue beside the edge; on a visible line in any direction. The sample
/// of a steep front is near the chord, but far from its middle.
double ErrorIndicator::distance_of_sample(const ChordSample& arc,
                                          const std::array<std::uint32_t, 3>& vertices,
                                          bool border) const {
  if (!arc.is_small_arc) return arc.distance();
  const auto& [a, b, sample] = vertices;
  const auto is_near = [this](std::uint32_t v) { return far_->contains(mesh_.position[v]); };
  const bool is_far = far_ && !std::ranges::all_of(vertices, is_near);
  if (border || is_far || !is_regular(sample)) return arc.distance_of_line();
  const dvec3& normal = mesh_.normal[sample];
  const ChordNormals chord = {loop_vector(arc.chord), loop_vector(mesh_.normal[a]),
                              loop_vector(mesh_.normal[b]), loop_vector(normal)};
  return largest_height(chord, arc.from_middle(), glm::dot(arc.off, normal));
}

/// The corner, 0 or 1, at which the diagonal with the smaller sagitta starts. cut_cell() of
/// mesh/grid/triangulate chooses it for most cells; the indicator ignores its other criteria.
std::size_t ErrorIndicator::first_of_diagonal(const Corners& corner) const {
  const auto arc = [&](std::size_t a, std::size_t b) {
    return sagitta(mesh_.position[corner[a]], mesh_.normal[corner[a]], mesh_.position[corner[b]],
                   mesh_.normal[corner[b]]);
  };
  return is_smaller(arc(1, 3), arc(0, 2)) ? 1 : 0;
}

double ErrorIndicator::square_of_tangent(std::uint32_t a, std::uint32_t b,
                                         std::uint32_t sample) const {
  if (!is_regular(a) || !is_regular(b) || !is_regular(sample)) return 0;
  return saddle::square_of_tangent(loop_vector(mesh_.normal[a]), loop_vector(mesh_.normal[b]),
                                   loop_vector(mesh_.normal[sample]));
}

double ErrorIndicator::turn_ratio(double square_of_tangent) const {
  if (square_of_tangent == 0) return 0;
  const double degrees = std::atan(std::sqrt(square_of_tangent)) * 180 / std::numbers::pi;
  const double share = degrees / limits_.normal_tolerance;
  return share * share;
}

}  // namespace saddle
