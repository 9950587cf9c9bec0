#include "mesh/model/edges.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace saddle {
namespace {

/// The corners at the ends of a triangle's side, in order.
IndexPair corners_of(const Mesh& mesh, const HalfEdge& side) {
  const Triangle& t = mesh.triangles[side.triangle()];
  const std::size_t k = side.side % 3;
  return std::minmax(t[k], t[(k + 1) % 3]);
}

}  // namespace

CornersOfPoints corners_of_points(const Mesh& mesh) {
  CornersOfPoints corners;
  const auto count = static_cast<std::uint32_t>(3 * mesh.triangles.size());
  const auto point_of = [&](std::uint32_t corner) {
    return mesh.point[mesh.triangles[corner / 3][corner % 3]];
  };
  corners.begin.resize(std::size_t{mesh.point_count} + 1);
  for (std::uint32_t c = 0; c < count; ++c) ++corners.begin[point_of(c)];
  std::partial_sum(corners.begin.begin(), corners.begin.end(), corners.begin.begin());
  corners.all.resize(count);
  // From the ends of points' parts to their beginnings.
  for (std::uint32_t c = count; c-- > 0;) corners.all[--corners.begin[point_of(c)]] = c;
  return corners;
}

void find_sides(const Mesh& mesh, std::span<const std::uint32_t> corners,
                std::vector<HalfEdge>& sides) {
  sides.clear();
  for (const std::uint32_t corner : corners) {
    const std::uint32_t t = corner / 3;
    const std::uint32_t k = corner % 3;
    const std::uint32_t before = (k + 2) % 3;
    const Triangle& triangle = mesh.triangles[t];
    const std::uint32_t last = mesh.point[triangle[before]];
    sides.push_back({mesh.point[triangle[(k + 1) % 3]], corner, false});
    if (last != mesh.point[triangle[k]]) sides.push_back({last, 3 * t + before, true});
  }
  std::ranges::sort(sides, [](const HalfEdge& a, const HalfEdge& b) {
    return a.to != b.to ? a.to < b.to : a.side < b.side;
  });
}

std::vector<std::vector<HalfEdge>> edges_between(const Mesh& mesh,
                                                 std::span<const HalfEdge> sides) {
  if (sides.size() == 1) return {{sides[0]}};
  std::map<IndexPair, std::vector<HalfEdge>> by_corners;
  for (const HalfEdge& side : sides) by_corners[corners_of(mesh, side)].push_back(side);
  std::vector<std::vector<HalfEdge>> edges;
  std::vector<HalfEdge> rest;
  for (auto& [corners, both] : by_corners) {
    if (both.size() == 2) {
      edges.push_back(std::move(both));
    } else {
      rest.insert(rest.end(), both.begin(), both.end());
    }
  }
  if (!rest.empty()) edges.push_back(std::move(rest));
  return edges;
}

}  // namespace saddle
