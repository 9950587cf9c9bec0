#include "mesh/model/edges.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace saddle {
namespace {

template <class F>
void for_each_side(const Mesh& mesh, F f) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.point[mesh.triangles[t][k]];
      const std::uint32_t b = mesh.point[mesh.triangles[t][(k + 1) % 3]];
      f(std::min(a, b), HalfEdge{std::max(a, b), 3 * t + k, a > b});
    }
  }
}

/// The corners at the ends of a triangle's side, in order.
IndexPair corners_of(const Mesh& mesh, const HalfEdge& side) {
  const Triangle& t = mesh.triangles[side.triangle()];
  const std::size_t k = side.side % 3;
  return std::minmax(t[k], t[(k + 1) % 3]);
}

}  // namespace

HalfEdges half_edges(const Mesh& mesh) {
  HalfEdges edges;
  edges.begin.resize(std::size_t{mesh.point_count} + 1);
  for_each_side(mesh, [&](std::uint32_t point, const HalfEdge&) { ++edges.begin[point + 1]; });
  std::partial_sum(edges.begin.begin(), edges.begin.end(), edges.begin.begin());
  edges.all.resize(edges.begin.back());
  std::vector<std::size_t> next(edges.begin.begin(), edges.begin.end() - 1);
  for_each_side(
      mesh, [&](std::uint32_t point, const HalfEdge& side) { edges.all[next[point]++] = side; });
  for (std::size_t p = 0; p < mesh.point_count; ++p) {
    std::sort(edges.all.begin() + static_cast<std::ptrdiff_t>(edges.begin[p]),
              edges.all.begin() + static_cast<std::ptrdiff_t>(edges.begin[p + 1]),
              [](const HalfEdge& a, const HalfEdge& b) {
                return a.to != b.to ? a.to < b.to : a.side < b.side;
              });
  }
  return edges;
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
