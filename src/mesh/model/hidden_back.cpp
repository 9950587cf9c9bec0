#include "mesh/model/hidden_back.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "mesh/model/tolerances.h"
#include "mesh/model/topology.h"

namespace saddle {
namespace {

/// Fewest stretches of a tube: with 3, the neighbours ahead and behind differ.
constexpr std::size_t kFewest = 3;

/// 1 if the tetrahedron of these vectors is oriented outward, -1 if inward or if a vector is not
/// finite, 0 if it is flat.
int orientation(const dvec3& a, const dvec3& b, const dvec3& c) {
  const double volume = glm::dot(a, glm::cross(b, c));
  const double flat = kRoundingOfSums * glm::length(a) * glm::length(b) * glm::length(c);
  if (std::abs(volume) <= flat) return 0;
  return volume > 0 ? 1 : -1;
}

/// False for most open meshes, at little cost. The sum of area vectors is the same for all surfaces
/// with one boundary, and 0 without a boundary.
bool may_be_closed(const Mesh& mesh) {
  dvec3 sum(0);
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const dvec3& p = mesh.position[a];
    const dvec3 twice = glm::cross(mesh.position[b] - p, mesh.position[c] - p);
    sum += twice;
    area += glm::length(twice);
  }
  return glm::length(sum) <= kNearly * area;
}

/// The parts of a mesh that shrink to a place each.
struct Stretches {
  std::vector<std::uint32_t> of_point;
  std::vector<dvec3> middle;
};

Stretches one_stretch(const Mesh& mesh) {
  return {std::vector<std::uint32_t>(mesh.point_count, 0), {mesh.bounds.centre()}};
}

/// Lines of constant u (`axis` 0) or v (1) that no triangle crosses, but for the last one.
std::vector<double> free_lines(const Mesh& mesh, int axis) {
  std::vector<std::array<double, 2>> ends;
  ends.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    const auto [low, high] = std::minmax({mesh.uv[a][axis], mesh.uv[b][axis], mesh.uv[c][axis]});
    ends.push_back({low, high});
  }
  std::ranges::sort(ends);
  std::vector<double> lines;
  double reached = -std::numeric_limits<double>::infinity();
  for (const auto& [low, high] : ends) {
    if (low >= reached) lines.push_back(low);
    reached = std::max(reached, high);
  }
  return lines;
}

/// The stretches from each free line to the next one. A point belongs to the stretch of its first
/// corner along the axis: a point on a seam to the first stretch.
Stretches stretches_along(const Mesh& mesh, int axis) {
  const std::vector<double> lines = free_lines(mesh, axis);
  std::vector<double> at(mesh.point_count, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < mesh.uv.size(); ++i) {
    at[mesh.point[i]] = std::min(at[mesh.point[i]], mesh.uv[i][axis]);
  }
  Stretches result;
  for (const double place : at) {
    const auto after = std::ranges::upper_bound(lines, place) - lines.begin();
    result.of_point.push_back(static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(after, 1) - 1));
  }
  std::vector<Bounds> boxes(lines.size());
  for (std::size_t i = 0; i < mesh.position.size(); ++i) {
    boxes[result.of_point[mesh.point[i]]].add(mesh.position[i]);
  }
  for (const Bounds& box : boxes) result.middle.push_back(box.centre());
  return result;
}

/// Whether the tetrahedra are oriented outward that a triangle sweeps while its corners move from
/// the middles of their stretches to their positions.
bool sweeps_outward(const Mesh& mesh, const Stretches& stretches, Triangle triangle) {
  const auto stretch = [&](std::size_t k) { return stretches.of_point[mesh.point[triangle[k]]]; };
  const auto count = static_cast<std::uint32_t>(stretches.middle.size());
  std::uint32_t ahead = 0;  // the next stretch, if the triangle has corners in it
  const auto is_in_order = [&] {
    ahead = (stretch(0) + 1) % count;
    return stretch(2) == ahead && (stretch(1) == stretch(0) || stretch(1) == ahead);
  };
  const bool is_in_one = stretch(0) == stretch(1) && stretch(1) == stretch(2);
  if (!is_in_one) {
    if (count < kFewest) return false;
    int turns = 0;
    for (; turns < 3 && !is_in_order(); ++turns) {
      std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    }
    if (turns == 3) return false;  // corners too far apart
  }
  const dvec3& from = stretches.middle[stretch(0)];
  const dvec3 a = mesh.position[triangle[0]] - from;
  const dvec3 b = mesh.position[triangle[1]] - from;
  const dvec3 c = mesh.position[triangle[2]] - from;
  if (orientation(a, b, c) < 0) return false;
  const bool has_side_ahead = !is_in_one && stretch(1) == ahead;
  return !has_side_ahead || orientation(stretches.middle[ahead] - from, c, b) >= 0;
}

bool sweeps_outward(const Mesh& mesh, const Stretches& stretches) {
  return std::ranges::all_of(mesh.triangles, [&](const Triangle& triangle) {
    return sweeps_outward(mesh, stretches, triangle);
  });
}

}  // namespace

bool hides_its_back(const Mesh& mesh) {
  if (mesh.triangles.empty() || !may_be_closed(mesh)) return false;
  if (!sweeps_outward(mesh, one_stretch(mesh)) && !sweeps_outward(mesh, stretches_along(mesh, 0)) &&
      !sweeps_outward(mesh, stretches_along(mesh, 1))) {
    return false;
  }
  const Topology shape = topology(mesh);
  return shape.is_closed() && shape.orientable;
}

}  // namespace saddle
