#include "mesh/distance/measure_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>

#include "base/numbers.h"
#include "base/parallel.h"
#include "mesh/distance/overlay.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/triangle_tree.h"

namespace saddle {
namespace {

/// The corners of the rectangles of a box, u inner. A box with a sphere has places inside if the
/// surface may jump there: most jumps have some of them on either side.
void append_points(const BoundedBox& box, std::vector<dvec2>& uv) {
  if (box.centre) {
    if (!box.may_jump) return;
    for (const dvec2& place : kPlacesInBox)
      uv.push_back(glm::mix(box.box.low, box.box.high, place));
    return;
  }
  const auto part = [](std::uint32_t k, std::uint32_t cells) {
    return cells == 0 ? 0.5 : static_cast<double>(k) / cells;
  };
  for (std::uint32_t j = 0; j <= box.cells[1]; ++j) {
    for (std::uint32_t i = 0; i <= box.cells[0]; ++i) {
      const dvec2 at(part(i, box.cells[0]), part(j, box.cells[1]));
      uv.push_back((1.0 - at) * box.box.low + at * box.box.high);
    }
  }
}

/// Two triangles with a common side: the numbers of the corners that are not on it.
std::optional<std::array<std::size_t, 2>> apexes_of(const Grid& grid, const Triangle& a,
                                                    const Triangle& b) {
  const auto& p = grid.mesh.position;
  std::array<std::size_t, 2> apex = {3, 3};
  const auto is_at = [&](const Triangle& other, const dvec3& place) {
    return p[other[0]] == place || p[other[1]] == place || p[other[2]] == place;
  };
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_at(b, p[a[k]])) {
      if (apex[0] < 3) return std::nullopt;
      apex[0] = k;
    }
    if (!is_at(a, p[b[k]])) apex[1] = k;
  }
  if (apex[0] == 3 || apex[1] == 3) return std::nullopt;
  return apex;
}

/// The plane of a triangle: the distance of a point from it.
struct Plane {
  Plane(const dvec3& a, const dvec3& b, const dvec3& c)
      : origin(a), normal(glm::normalize(glm::cross(b - a, c - a))) {}
  double distance(const dvec3& p) const { return std::fabs(glm::dot(p - origin, normal)); }
  dvec3 origin, normal;
};

}  // namespace

/// A bound of the distance from triangles a and b of any point between points on a and points on b.
/// A line from a to b crosses the common side, if the two make a convex quadrilateral, at most as
/// far from it as its end on b is from the plane of a.
double BoxMeasure::fold_between(const Triangle& a, const Triangle& b, const Corners& corners,
                                std::span<const NearestTriangle> nearest) const {
  const auto apex = apexes_of(grid_, a, b);
  if (!apex) return kInfinity;
  const auto& position = grid_.mesh.position;
  const dvec3 from = position[a[((*apex)[0] + 1) % 3]];
  const dvec3 to = position[a[((*apex)[0] + 2) % 3]];
  const dvec3 over_a = position[a[(*apex)[0]]];
  const dvec3 over_b = position[b[(*apex)[1]]];
  const Plane plane(from, to, over_a);
  const auto turn = [&](const dvec3& p, const dvec3& q, const dvec3& r) {
    return glm::dot(glm::cross(q - p, r - q), plane.normal);
  };
  const bool is_convex = turn(over_a, from, over_b) > 0 && turn(over_b, to, over_a) > 0;
  if (!is_convex) return kInfinity;  // true for NaN
  double fold = 0;
  for (const std::size_t k : corners) {
    if (nearest[k].triangle == b) fold = std::max(fold, plane.distance(nearest[k].point));
  }
  return fold;
}

BoxMeasure::BoxMeasure(const Surface& surface, const Grid& grid, const Patches& patches,
                       Triangles triangles, const std::optional<Bounds>& clip, ProofBudget& budget,
                       unsigned threads)
    : surface_(surface),
      grid_(grid),
      patches_(patches),
      triangles_(std::move(triangles)),
      clip_(clip),
      budget_(budget),
      threads_(threads) {}

/// The triangles of patches are near most boxes, which are measured on several threads. Triangles
/// of the whole mesh are searched for the others, in their order: what that takes of the budget
/// decides how many there are.
std::vector<ProofOutcome> BoxMeasure::operator()(std::span<const BoundedBox> boxes) {
  std::vector<dvec2> uv;
  std::vector<std::size_t> first = {0};  // the first point of each box, and the end of all
  for (const BoundedBox& box : boxes) {
    append_points(box, uv);
    first.push_back(uv.size());
  }
  const std::vector<dvec3> points = evaluate_positions(surface_, uv, threads_);
  const auto points_of = [&](std::size_t k) {
    const std::size_t count = first[k + 1] - first[k];
    return Points{std::span(uv).subspan(first[k], count),
                  std::span(points).subspan(first[k], count)};
  };
  std::vector<std::optional<ProofOutcome>> of_patches(boxes.size());
  parallel_chunks(boxes.size(), kSearchedTogether, threads_,
                  [&](std::size_t begin, std::size_t end) {
                    std::vector<NearestTriangle> nearest;
                    for (std::size_t k = begin; k < end; ++k)
                      of_patches[k] = measure_from_patch(boxes[k], points_of(k), nearest);
                  });
  std::vector<ProofOutcome> outcomes;
  outcomes.reserve(boxes.size());
  for (std::size_t k = 0; k < boxes.size(); ++k)
    outcomes.push_back(of_patches[k] ? *of_patches[k] : measure_from_mesh(boxes[k], points_of(k)));
  return outcomes;
}

const NearestTriangles& BoxMeasure::tree() {
  if (!tree_) tree_.emplace(triangles_.all());
  return *tree_;
}

/// The nearest triangle of the mesh. Among many sheets that takes a visit of most of them.
NearestTriangle BoxMeasure::search(const dvec3& position, double enough,
                                   const NearestTriangle& known) {
  std::size_t visited = 0;
  const NearestTriangle found = tree().nearest(position, enough, known, visited);
  budget_.take_visits(visited);
  if (const auto& count = surface_.tangents.count) count->add_work(visited / kVisitsPerPoint);
  return found;
}

/// A triangle of a patch that is near enough, first the one of the point before; else the nearest
/// of those. `before`: of the points before.
NearestTriangle BoxMeasure::nearest_of_patch(std::size_t patch, const dvec3& position,
                                             double enough,
                                             std::span<const NearestTriangle> before) const {
  NearestTriangle nearest;
  if (!before.empty()) nearest = nearest_point(grid_, before.back().triangle, position);
  for (const Triangle& t : triangles_.of(patch)) {
    if (nearest.distance <= enough) return nearest;
    if (!before.empty() && t == before.back().triangle) continue;
    const NearestTriangle own = nearest_point(grid_, t, position);
    if (own.distance < nearest.distance) nearest = own;
  }
  return nearest;
}

/// Where none of the patch is near enough, the nearest of the mesh; none if it may not be searched
/// for.
std::optional<NearestTriangle> BoxMeasure::nearest(std::size_t patch, const dvec3& position,
                                                   double enough,
                                                   std::span<const NearestTriangle> before) {
  const NearestTriangle of_patch = nearest_of_patch(patch, position, enough, before);
  if (of_patch.distance <= enough) return of_patch;
  if (!budget_.may_visit()) return std::nullopt;
  return search(position, enough, of_patch);
}

double BoxMeasure::distance_from_mesh(const dvec3& position, double known) {
  NearestTriangle nearest;
  nearest.distance = known;
  return search(position, 0, nearest).distance;
}

/// The outcome if all points are near triangles of the patch. `nearest`: where those are kept.
std::optional<ProofOutcome> BoxMeasure::measure_from_patch(
    const BoundedBox& box, const Points& points, std::vector<NearestTriangle>& nearest) const {
  const double allowed = patches_[box.patch].allowed;
  nearest.clear();
  for (const dvec3& p : points.positions) {
    nearest.push_back(nearest_of_patch(box.patch, p, allowed, nearest));
    if (!(nearest.back().distance <= allowed)) return std::nullopt;
  }
  const double most = kProofFactor * allowed - box.reach;
  if (box.centre) {
    const double distance = nearest_of_patch(box.patch, *box.centre, most, nearest).distance;
    return distance <= most ? std::optional(ProofOutcome::Proved) : std::nullopt;
  }
  return are_rectangles_near(box, points.positions, nearest) ? ProofOutcome::Proved
                                                             : ProofOutcome::Open;
}

ProofOutcome BoxMeasure::measure_from_mesh(const BoundedBox& box, const Points& points) {
  const double allowed = patches_[box.patch].allowed;
  double worst = 0;
  std::size_t farthest = 0;
  std::vector<NearestTriangle> nearest_ones;
  for (std::size_t k = 0; k < points.uv.size(); ++k) {
    const dvec3& p = points.positions[k];
    const auto found = nearest(box.patch, p, allowed, nearest_ones);
    if (!found) return ProofOutcome::Open;
    nearest_ones.push_back(*found);
    if (!(found->distance > worst) || (clip_ && !clip_->contains(p))) continue;
    worst = found->distance;
    farthest = k;
  }
  if (worst > allowed) {
    // On a jump the surface may have a value of its own, as sign(u) has at 0: no mesh shows it.
    if (patches_[box.patch].jump_line) return ProofOutcome::Refuted;
    const dvec2 size = box.box.size() / glm::max(dvec2(box.cells[0], box.cells[1]), dvec2(1));
    found_.push_back(
        {{points.uv[farthest], points.positions[farthest], size, box.bend, box.patch}, worst});
    return ProofOutcome::Refuted;
  }
  if (box.centre) {
    const double most = kProofFactor * allowed - box.reach;
    const auto found = nearest(box.patch, *box.centre, most, nearest_ones);
    return found && found->distance <= most ? ProofOutcome::Proved : ProofOutcome::Open;
  }
  return are_rectangles_near(box, points.positions, nearest_ones) ? ProofOutcome::Proved
                                                                  : ProofOutcome::Open;
}

/// Whether triangles are near the rectangles between the points of a box. `nearest`: of the points.
bool BoxMeasure::are_rectangles_near(const BoundedBox& box, std::span<const dvec3> points,
                                     std::span<const NearestTriangle> nearest) const {
  const double most = kProofFactor * patches_[box.patch].allowed - box.reach;
  const std::size_t row = box.cells[0] + 1;
  // A range that is not divided has one point.
  const std::size_t next_u = box.cells[0] > 0 ? 1 : 0;
  const std::size_t next_v = box.cells[1] > 0 ? row : 0;
  for (std::size_t j = 0; j < std::max(box.cells[1], 1U); ++j) {
    for (std::size_t i = 0; i < std::max(box.cells[0], 1U); ++i) {
      const std::size_t k = j * row + i;
      const Corners corners = {k, k + next_u, k + next_v, k + next_v + next_u};
      if (!is_near(corners, nearest, most) && !is_over_patch(box, corners, points, most))
        return false;
    }
  }
  return true;
}

/// Whether two triangles between the points of a rectangle are over those of a box's patch.
bool BoxMeasure::is_over_patch(const BoundedBox& box, const Corners& corners,
                               std::span<const dvec3> points, double most) const {
  if (box.cells[0] == 0 || box.cells[1] == 0) return false;
  const std::span<const Triangle> triangles = triangles_.of(box.patch);
  return std::ranges::all_of(std::array{corners[1], corners[2]}, [&](std::size_t other) {
    return is_over({points[corners[0]], points[other], points[corners[3]]}, grid_, triangles, most);
  });
}

/// Whether the convex hull of points is near one triangle, or two with a common side. The distance
/// from a convex set is a convex function: of the hull, the points have the largest.
bool BoxMeasure::is_near(const Corners& corners, std::span<const NearestTriangle> nearest,
                         double most) const {
  const Triangle& a = nearest[corners[0]].triangle;
  const Triangle* other = nullptr;
  double worst = 0;
  for (const std::size_t k : corners) {
    const Triangle& t = nearest[k].triangle;
    worst = std::max(worst, nearest[k].distance);
    if (t == a) continue;
    if (other != nullptr && *other != t) return false;
    other = &t;
  }
  if (!(worst <= most)) return false;
  return other == nullptr || worst + fold_between(a, *other, corners, nearest) <= most ||
         worst + fold_between(*other, a, corners, nearest) <= most;
}

}  // namespace saddle
