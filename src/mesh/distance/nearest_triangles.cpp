#include "mesh/distance/nearest_triangles.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <glm/common.hpp>

#include "mesh/distance/sampled_error.h"
#include "mesh/model/tolerances.h"

namespace saddle {
namespace {

double square_of_distance(const Bounds& box, const dvec3& p) {
  if (box.empty()) return std::numeric_limits<double>::infinity();
  const dvec3 off = p - glm::clamp(p, box.low, box.high);
  return glm::dot(off, off);
}

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

NearestTriangles::NearestTriangles(const Grid& grid, Array<Triangle> triangles)
    : grid_(grid),
      triangles_(std::move(triangles)),
      leaves_(std::bit_ceil(triangles_.size() / kTrianglesOfNode + 1)) {
  boxes_.resize(2 * leaves_ - 1);
  for (std::size_t k = 0; k < triangles_.size(); ++k) {
    for (const std::uint32_t corner : triangles_[k])
      boxes_[leaves_ - 1 + k / kTrianglesOfNode].add(grid.mesh.position[corner]);
  }
  for (std::size_t k = leaves_ - 1; k-- > 0;) {
    for (const Bounds& half : {boxes_[2 * k + 1], boxes_[2 * k + 2]}) {
      if (half.empty()) continue;
      boxes_[k].add(half.low);
      boxes_[k].add(half.high);
    }
  }
}

NearestTriangle NearestTriangles::nearest(const dvec3& position, double enough,
                                          NearestTriangle known) const {
  std::vector<std::size_t> open = {0};
  while (!open.empty() && !(known.distance <= enough)) {
    const std::size_t k = open.back();
    open.pop_back();
    if (square_of_distance(boxes_[k], position) >= known.distance * known.distance) continue;
    if (k >= leaves_ - 1) {
      const std::size_t first = (k - (leaves_ - 1)) * kTrianglesOfNode;
      const std::size_t end = std::min(first + kTrianglesOfNode, triangles_.size());
      for (std::size_t t = first; t < end; ++t) {
        const NearestTriangle own = nearest_point(grid_, triangles_[t], position);
        if (own.distance < known.distance) known = own;
      }
      continue;
    }
    const std::size_t a = 2 * k + 1;
    const bool is_first_nearer =
        square_of_distance(boxes_[a], position) <= square_of_distance(boxes_[a + 1], position);
    open.push_back(is_first_nearer ? a + 1 : a);
    open.push_back(is_first_nearer ? a : a + 1);
  }
  return known;
}

}  // namespace saddle
