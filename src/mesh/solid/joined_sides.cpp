#include "mesh/solid/joined_sides.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <span>
#include <tuple>
#include <utility>

#include "base/numbers.h"
#include "mesh/model/edges.h"

namespace saddle {
namespace {

/// From a side into its triangle, at right angles to the side: a unit vector, 0 without an area.
dvec3 inward(const Mesh& mesh, const HalfEdge& side) {
  const Triangle& t = mesh.triangles[side.triangle()];
  const std::size_t k = side.side % 3;
  const dvec3& a = mesh.position[t[k]];
  const dvec3 along = mesh.position[t[(k + 1) % 3]] - a;
  const dvec3 to_apex = mesh.position[t[(k + 2) % 3]] - a;
  const double square = glm::dot(along, along);
  const dvec3 way = square > 0 ? to_apex - glm::dot(to_apex, along) / square * along : to_apex;
  const double length = glm::length(way);
  return length > 0 ? way / length : dvec3(0);
}

/// Parts three sides or more into pairs that go on straight, the straightest first; what is left
/// over is alone.
std::vector<std::vector<HalfEdge>> pairs_by_angle(const Mesh& mesh,
                                                  std::span<const HalfEdge> sides) {
  std::vector<dvec3> ways;
  for (const HalfEdge& side : sides) ways.push_back(inward(mesh, side));
  std::vector<std::tuple<double, std::size_t, std::size_t>> bends;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      bends.emplace_back(glm::dot(ways[i], ways[j]), i, j);
    }
  }
  std::ranges::sort(bends);
  std::vector<bool> is_taken(sides.size());
  std::vector<std::vector<HalfEdge>> edges;
  for (const auto& [bend, i, j] : bends) {
    if (is_taken[i] || is_taken[j]) continue;
    is_taken[i] = is_taken[j] = true;
    edges.push_back({sides[i], sides[j]});
  }
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!is_taken[i]) edges.push_back({sides[i]});
  }
  return edges;
}

/// All edges between two points, each of one or two sides.
std::vector<std::vector<HalfEdge>> narrow_edges_between(const Mesh& mesh,
                                                        std::span<const HalfEdge> sides) {
  std::vector<std::vector<HalfEdge>> edges;
  for (std::vector<HalfEdge>& edge : edges_between(mesh, sides)) {
    if (edge.size() <= 2) {
      edges.push_back(std::move(edge));
    } else {
      std::ranges::move(pairs_by_angle(mesh, edge), std::back_inserter(edges));
    }
  }
  return edges;
}

bool is_flat(const Mesh& mesh, const Triangle& t) {
  const std::uint32_t a = mesh.point[t[0]];
  const std::uint32_t b = mesh.point[t[1]];
  const std::uint32_t c = mesh.point[t[2]];
  return a == b || b == c || c == a;
}

/// Adds a corner in the middle of two others.
std::uint32_t add_middle(std::uint32_t a, std::uint32_t b, std::uint32_t point, Mesh& mesh) {
  const dvec3 normal = mesh.normal[a] + mesh.normal[b];
  const double length = glm::length(normal);
  const auto corner = static_cast<std::uint32_t>(mesh.position.size());
  const dvec3 own_normal = mesh.normal[a];
  mesh.position.push_back(0.5 * mesh.position[a] + 0.5 * mesh.position[b]);
  mesh.normal.push_back(length > 0 ? normal / length : own_normal);
  mesh.uv.push_back(0.5 * mesh.uv[a] + 0.5 * mesh.uv[b]);
  mesh.point.push_back(std::uint32_t{point});
  if (!mesh.color.empty()) mesh.color.push_back(0.5 * mesh.color[a] + 0.5 * mesh.color[b]);
  return corner;
}

/// Cuts a triangle at the middles of some of its sides; kNoIndex: the side has none.
void cut(const Triangle& t, const std::array<std::uint32_t, 3>& middle, Array<Triangle>& cut_ones) {
  std::vector<std::uint32_t> polygon;
  std::size_t first = 0;  // a middle: no two other corners are on a line with it
  for (std::size_t k = 0; k < 3; ++k) {
    polygon.push_back(t[k]);
    if (middle[k] == kNoIndex) continue;
    first = polygon.size();
    polygon.push_back(middle[k]);
  }
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(first), polygon.end());
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    cut_ones.push_back({polygon[0], polygon[k], polygon[k + 1]});
  }
}

}  // namespace

JoinedSides join_sides(const Mesh& mesh) {
  JoinedSides joined;
  joined.across.assign(3 * mesh.triangles.size(), kNoIndex);
  const auto join = [&](const HalfEdge& a, const HalfEdge& b) {
    joined.across[a.side] = b.side;
    joined.across[b.side] = a.side;
  };
  for_each_pair(mesh, [&](std::uint32_t, std::span<const HalfEdge> sides) {
    if (sides.size() == 2) join(sides[0], sides[1]);
    if (sides.size() <= 2) return;
    bool is_first = true;
    for (const std::vector<HalfEdge>& edge : narrow_edges_between(mesh, sides)) {
      if (edge.size() == 2) join(edge[0], edge[1]);
      for (const HalfEdge& side : edge) {
        if (!is_first) joined.doubled.push_back(side.side);
      }
      is_first = false;
    }
  });
  return joined;
}

bool has_flat_triangles(const Mesh& mesh) {
  return std::ranges::any_of(mesh.triangles, [&](const Triangle& t) { return is_flat(mesh, t); });
}

Mesh without_flat_triangles(Mesh mesh) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) { return is_flat(mesh, t); });
  return mesh;
}

Mesh with_single_edges(Mesh mesh, const JoinedSides& joined) {
  std::map<std::uint32_t, std::uint32_t> middle;  // corners in the middle of sides
  for (const std::uint32_t side : joined.doubled) {
    const Triangle t = mesh.triangles[side / 3];
    const std::uint32_t other = joined.across[side];
    const bool is_known = other != kNoIndex && middle.contains(other);
    const std::uint32_t point = is_known ? mesh.point[middle[other]] : mesh.point_count++;
    middle[side] = add_middle(t[side % 3], t[(side + 1) % 3], point, mesh);
  }
  Array<Triangle> triangles;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    std::array<std::uint32_t, 3> middles = {kNoIndex, kNoIndex, kNoIndex};
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (const auto found = middle.find(3 * t + k); found != middle.end()) {
        middles[k] = found->second;
      }
    }
    cut(mesh.triangles[t], middles, triangles);
  }
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace saddle
