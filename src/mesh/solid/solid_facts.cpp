#include "mesh/solid/solid_facts.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "base/compensated_sum.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/topology.h"
#include "mesh/model/triangle_tree.h"

namespace saddle {
namespace {

/// Pairs of triangles whose boxes meet are tested up to so many for each triangle. Solids that fold
/// or cross along curves have fewer than 30.
constexpr std::size_t kTestsPerTriangle = 64;

using Corners = std::array<dvec3, 3>;

/// 1 if d is on the side of the plane of a, b and c that they turn counter-clockwise for, -1 if it
/// is beyond, 0 if rounding could have decided.
int side_of(const dvec3& a, const dvec3& b, const dvec3& c, const dvec3& d) {
  const dvec3 p = a - d;
  const dvec3 q = b - d;
  const dvec3 r = c - d;
  const double volume = glm::dot(p, glm::cross(q, r));
  const double flat = kRoundingOfSums * glm::length(p) * glm::length(q) * glm::length(r);
  if (std::abs(volume) <= flat) return 0;
  return volume > 0 ? 1 : -1;
}

/// The straight way from p to q goes through the inside of a triangle.
bool pierces(const dvec3& p, const dvec3& q, const Corners& t) {
  const int first = side_of(p, q, t[0], t[1]);
  return first != 0 && side_of(p, q, t[1], t[2]) == first && side_of(p, q, t[2], t[0]) == first;
}

/// A side of one triangle goes through the other. `sides`: where the corners are beside the plane
/// of the other.
bool sides_pierce(const Corners& t, const std::array<int, 3>& sides, const Corners& other) {
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    if (sides[k] * sides[next] < 0 && pierces(t[k], t[next], other)) return true;
  }
  return false;
}

std::array<int, 3> sides_of(const Corners& t, const Corners& plane) {
  std::array<int, 3> sides{};
  for (std::size_t k = 0; k < 3; ++k) sides[k] = side_of(plane[0], plane[1], plane[2], t[k]);
  return sides;
}

bool are_all_on_one_side(const std::array<int, 3>& sides) {
  return sides[0] * sides[1] > 0 && sides[1] * sides[2] > 0;
}

bool cross(const Corners& a, const Corners& b) {
  const std::array<int, 3> sides_a = sides_of(a, b);
  if (are_all_on_one_side(sides_a)) return false;
  const std::array<int, 3> sides_b = sides_of(b, a);
  if (are_all_on_one_side(sides_b)) return false;
  return sides_pierce(a, sides_a, b) || sides_pierce(b, sides_b, a);
}

/// By the volumes of the tetrahedra between the triangles and the middle of the box, which
/// keeps their rounding small.
double volume_of(const Mesh& solid) {
  const dvec3 middle = solid.bounds.centre();
  CompensatedSum sum;
  for (const auto& [a, b, c] : solid.triangles) {
    sum.add(glm::dot(solid.position[a] - middle,
                     glm::cross(solid.position[b] - middle, solid.position[c] - middle)));
  }
  return sum.value() / 6;
}

}  // namespace

Crossings count_crossings(const Mesh& mesh, unsigned threads) {
  const auto corners_of = [&](const Triangle& t) {
    return Corners{mesh.position[t[0]], mesh.position[t[1]], mesh.position[t[2]]};
  };
  const auto touch = [&](const Triangle& a, const Triangle& b) {
    for (const std::uint32_t i : a) {
      for (const std::uint32_t j : b) {
        if (mesh.point[i] == mesh.point[j]) return true;
      }
    }
    return false;
  };
  const TriangleTree tree(mesh, threads);
  const PairCount count = tree.count_pairs(
      [&](std::uint32_t i, std::uint32_t j) {
        const Triangle& a = mesh.triangles[i];
        const Triangle& b = mesh.triangles[j];
        return !touch(a, b) && cross(corners_of(a), corners_of(b));
      },
      kTestsPerTriangle * mesh.triangles.size(), threads);
  return {count.passed, count.is_complete};
}

SolidFacts solid_facts(const Mesh& solid, unsigned threads) {
  const Topology shape = topology(solid);
  SolidFacts facts;
  facts.closed = shape.is_closed() && shape.orientable;
  facts.shells = shape.components;
  facts.volume = volume_of(solid);
  facts.crossings = count_crossings(solid, threads);
  return facts;
}

}  // namespace saddle
