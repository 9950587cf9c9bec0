#include "mesh/distance/nearest_triangles.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/common.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

/// A node that may hold a nearer triangle.
struct Open {
  std::size_t node;
  double square;  // of the distance of its box, in local units
};

}  // namespace

NearestTriangle nearest_point(const Grid& grid, const Triangle& triangle, const dvec3& position) {
  const auto& p = grid.mesh.position;
  for (const std::uint32_t corner : triangle) {
    if (p[corner] == position) return {triangle, position, 0};
  }
  const WeightedDistance nearest = nearest_weights(grid, triangle, position);
  const dvec3& w = nearest.weights;
  return {triangle, w.x * p[triangle[0]] + w.y * p[triangle[1]] + w.z * p[triangle[2]],
          nearest.distance};
}

NearestTriangles::NearestTriangles(const Grid& grid, std::span<const Triangle> triangles)
    : grid_(grid),
      triangles_(triangles),
      leaves_(std::bit_ceil(triangles_.size() / kTrianglesOfNode + 1)) {
  // Boxes above fewer than kTrianglesOfNode leaves are three quarters of all. They are not stored
  // where they take much memory.
  const std::size_t lowest = leaves_ > 2 * kKeptAtATime ? leaves_ / kTrianglesOfNode : leaves_;
  std::vector<Bounds> boxes(2 * lowest - 1);
  for (std::size_t k = boxes.size(); k-- > 0;) {
    if (k >= lowest - 1) {
      boxes[k] = box_of(k);
      continue;
    }
    for (const Bounds& half : {boxes[2 * k + 1], boxes[2 * k + 2]}) {
      if (half.empty()) continue;
      boxes[k].add(half.low);
      boxes[k].add(half.high);
    }
  }
  boxes_ = std::move(boxes);
}

/// The triangles below a node: equal parts of all leaves for the nodes of a level.
std::span<const Triangle> NearestTriangles::triangles_of(std::size_t node) const {
  const std::size_t first_of_level = std::bit_floor(node + 1);
  const std::size_t count = leaves_ / first_of_level * kTrianglesOfNode;
  const std::size_t first = std::min((node + 1 - first_of_level) * count, triangles_.size());
  return triangles_.subspan(first, std::min(count, triangles_.size() - first));
}

Bounds NearestTriangles::box_of(std::size_t node) const {
  if (node < boxes_.size()) return boxes_[node];
  Bounds box;
  for (const Triangle& triangle : triangles_of(node)) {
    for (const std::uint32_t corner : triangle) box.add(grid_.mesh.position[corner]);
  }
  return box;
}

double NearestTriangles::square_of_distance(std::size_t node, const dvec3& p) const {
  const Bounds box = box_of(node);
  if (box.empty()) return std::numeric_limits<double>::infinity();
  const dvec3 off = grid_.local_scale * (p - glm::clamp(p, box.low, box.high));
  return glm::dot(off, off);
}

NearestTriangle NearestTriangles::nearest(const dvec3& position, double enough,
                                          NearestTriangle known, std::size_t& visited) const {
  std::vector<Open> open = {{0, square_of_distance(0, position)}};
  while (!open.empty() && !(known.distance <= enough)) {
    const auto [k, square] = open.back();
    open.pop_back();
    ++visited;
    const double least = grid_.local_scale * known.distance;
    if (square >= least * least) continue;
    if (k >= leaves_ - 1) {
      for (const Triangle& triangle : triangles_of(k)) {
        const NearestTriangle own = nearest_point(grid_, triangle, position);
        if (own.distance < known.distance) known = own;
      }
      continue;
    }
    Open first = {2 * k + 1, square_of_distance(2 * k + 1, position)};
    Open second = {2 * k + 2, square_of_distance(2 * k + 2, position)};
    if (!(first.square <= second.square)) std::swap(first, second);
    open.push_back(second);
    open.push_back(first);
  }
  return known;
}

}  // namespace saddle
