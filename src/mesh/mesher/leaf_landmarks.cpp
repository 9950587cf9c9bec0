#include "mesh/mesher/leaf_landmarks.h"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "mesh/distance/nearest_triangles.h"
#include "mesh/distance/sampled_error.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

namespace {

/// Whether leaves have a point in common.
bool touch(const Leaf& a, const Leaf& b) {
  return a.low.u <= b.high().u && b.low.u <= a.high().u && a.low.v <= b.high().v &&
         b.low.v <= a.high().v;
}

/// How deep a triangle reaches into a hole around a place; 0 if the place is not in the triangle.
double depth_in_hole(const Grid& grid, std::span<const Triangle> triangles, const Landmark& hole) {
  if (triangles.empty()) return 0;
  const auto [own, weights] = triangle_below(grid, triangles, hole.uv);
  if (std::min({weights.x, weights.y, weights.z}) < 0) return 0;
  const auto& [a, b, c] = *own;
  const Mesh& mesh = grid.mesh;
  const dvec2 b_uv = mesh.uv[b] - mesh.uv[a];
  const dvec2 c_uv = mesh.uv[c] - mesh.uv[a];
  const dvec3 b_r = mesh.position[b] - mesh.position[a];
  const dvec3 c_r = mesh.position[c] - mesh.position[a];
  const double area = cross(b_uv, c_uv);
  if (area == 0) return 0;
  const dvec3 r_u = (c_uv.y * b_r - b_uv.y * c_r) / area;
  const dvec3 r_v = (b_uv.x * c_r - c_uv.x * b_r) / area;
  return depth_of(hole.rim, r_u, r_v);
}

}  // namespace

LeafLandmarks::LeafLandmarks(const std::vector<Landmark>& all, const std::optional<Bounds>& clip,
                             const Grid& grid, const CellTree& tree)
    : grid_(grid), tree_(tree) {
  for (const Landmark& landmark : all) {
    if (landmark.is_hole() || !clip || clip->contains(landmark.position))
      places_.push_back(landmark);
  }
  std::ranges::stable_sort(places_, {}, [](const Landmark& landmark) { return landmark.uv.x; });
  for (const Landmark& landmark : places_) is_missed_.push_back(landmark.is_hole() ? 0 : 1);
}

std::vector<std::uint32_t> LeafLandmarks::landmarks_in(const Leaf& leaf) const {
  std::vector<std::uint32_t> found;
  if (places_.empty()) return found;
  const dvec2 a = tree_.vertices().parameters(leaf.low);
  const dvec2 b = tree_.vertices().parameters(leaf.high());
  const dvec2 low = glm::min(a, b);
  const dvec2 high = glm::max(a, b);
  const auto first =
      std::ranges::lower_bound(places_, low.x, {}, [](const Landmark& at) { return at.uv.x; });
  for (auto at = first; at != places_.end() && at->uv.x <= high.x; ++at) {
    if (at->uv.y >= low.y && at->uv.y <= high.y)
      found.push_back(static_cast<std::uint32_t>(at - places_.begin()));
  }
  return found;
}

void LeafLandmarks::append_missed(std::span<const Leaf> leaves,
                                  std::vector<Counterexample>& counterexamples) const {
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    for (const std::uint32_t number : landmarks_in(leaves[k])) {
      if (is_missed_[number] == 0) continue;
      const Landmark& landmark = places_[number];
      counterexamples.push_back(
          {landmark.uv, landmark.position, landmark.size, landmark.across, k, landmark.speed});
    }
  }
}

double LeafLandmarks::distance(const Landmark& landmark,
                               std::span<const Triangle> triangles) const {
  if (landmark.is_hole()) return depth_in_hole(grid_, triangles, landmark);
  return triangles.empty() ? std::numeric_limits<double>::infinity()
                           : distance_from(grid_, triangles, landmark.uv, landmark.position);
}

/// Takes the distances from the triangles of leaves that touch those of the landmarks, where they
/// are smaller: a feature that cuts off a leaf's corner between two vertices belongs to a
/// neighbour.
void LeafLandmarks::move_to_neighbours(std::vector<Far>& far, const ValidatedMesh& mesh) const {
  const auto low_u = [&mesh](const Far& place) { return mesh.leaves[place.leaf].low.u; };
  std::ranges::stable_sort(far, {}, low_u);
  std::uint32_t widest = 0;
  for (const Far& place : far) widest = std::max(widest, mesh.leaves[place.leaf].size_u());
  for (std::size_t k = 0; k < mesh.triangles.ranges.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    const std::uint32_t from = std::max(leaf.low.u, widest) - widest;
    const std::uint32_t to = leaf.high().u;
    for (auto place = std::ranges::lower_bound(far, from, {}, low_u);
         place != far.end() && low_u(*place) <= to; ++place) {
      if (touch(leaf, mesh.leaves[place->leaf]))
        place->distance =
            std::min(place->distance, distance(places_[place->landmark], mesh.triangles.of(k)));
    }
  }
}

void LeafLandmarks::measure(std::span<const std::size_t> which, ValidatedMesh& mesh) {
  if (places_.empty()) return;
  const auto take = [&](const Far& found) {
    const double allowed = mesh.allowed[found.leaf];
    is_missed_[found.landmark] = found.distance > allowed ? 1 : 0;
    mesh.add(found.leaf, std::isfinite(found.distance) ? found.distance : kMostSafety * allowed,
             places_[found.landmark].uv);
  };
  std::vector<Far> far;
  for (const std::size_t k : which) {
    const Leaf& leaf = mesh.leaves[k];
    const bool is_left_out = leaf.state.leads_to_pole() || leaf.state.is_left_out();
    for (const std::uint32_t number : landmarks_in(leaf)) {
      is_missed_[number] = 0;
      if (is_left_out) continue;
      const Landmark& landmark = places_[number];
      const Far found{number, k, distance(landmark, mesh.triangles.of(k))};
      found.distance > mesh.allowed[k] && !landmark.is_hole() ? far.push_back(found) : take(found);
    }
  }
  if (far.empty()) return;
  move_to_neighbours(far, mesh);
  std::ranges::for_each(far, take);
}

bool LeafLandmarks::misses_hole(const Leaf& leaf) const {
  return std::ranges::any_of(landmarks_in(leaf), [this](std::uint32_t number) {
    return is_missed_[number] != 0 && places_[number].is_hole();
  });
}

void LeafLandmarks::complete(std::span<const Triangle> triangles, double tolerance,
                             MeshReport& report) const {
  if (triangles.empty()) return;
  std::optional<NearestTriangles> whole;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    if (is_missed_[k] == 0 || places_[k].is_hole()) continue;
    if (!whole) whole.emplace(grid_, triangles);
    std::size_t visited = 0;
    // A triangle within the largest known error is enough.
    const double error =
        whole->nearest(places_[k].position, report.max_error, {}, visited).distance;
    if (error > std::max(report.max_error, tolerance)) report.worst_place = places_[k].uv;
    report.max_error = std::max(report.max_error, error);
  }
}

}  // namespace saddle
