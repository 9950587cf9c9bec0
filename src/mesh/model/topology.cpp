#include "mesh/model/topology.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "mesh/model/edges.h"

namespace saddle {

namespace {

/// Sets of numbers that are joined, each member with a sign relative to its set's first.
/// Source: B. Galler, M. Fischer, "An improved equivalence algorithm", 1964.
class SignedSets {
 public:
  explicit SignedSets(std::size_t count) : parent_(count), turned_(count, 0) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// Joins the sets of two members, which are alike or turned against each other. False if they
  /// are in one set with the other sign.
  bool join(std::uint32_t a, std::uint32_t b, bool turned) {
    const auto [root_a, turned_a] = find(a);
    const auto [root_b, turned_b] = find(b);
    if (root_a == root_b) return (turned_a != turned_b) == turned;
    parent_[root_b] = root_a;
    turned_[root_b] = (turned_a != turned_b) != turned ? 1 : 0;
    return true;
  }
  bool is_first(std::uint32_t a) const { return parent_[a] == a; }
  /// The first member of the set, and whether `a` is turned against it.
  std::pair<std::uint32_t, bool> find(std::uint32_t a) {
    std::uint32_t root = a;
    bool turned = false;
    for (; parent_[root] != root; root = parent_[root]) turned ^= turned_[root] != 0;
    // Path compression.
    bool rest = turned;
    while (parent_[a] != root && a != root) {
      const std::uint32_t next = parent_[a];
      const bool own = turned_[a] != 0;
      parent_[a] = root;
      turned_[a] = rest ? 1 : 0;
      rest ^= own;
      a = next;
    }
    return {root, turned};
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint8_t> turned_;
};

/// Number of a triangle's corner at a point, among all corners of triangles.
std::uint32_t corner_at(const Mesh& mesh, std::uint32_t triangle, std::uint32_t point) {
  std::uint32_t k = 0;
  while (k < 2 && mesh.point[mesh.triangles[triangle][k]] != point) ++k;
  return 3 * triangle + k;
}

/// Points whose triangles are parts that share no edge there. `fans`: corners of triangles that do.
std::size_t count_pinched(const Mesh& mesh, const SignedSets& fans) {
  std::vector<std::uint8_t> parts(mesh.point_count);
  for (std::uint32_t corner = 0; corner < 3 * mesh.triangles.size(); ++corner) {
    std::uint8_t& count = parts[mesh.point[mesh.triangles[corner / 3][corner % 3]]];
    if (fans.is_first(corner) && count < 2) ++count;
  }
  return static_cast<std::size_t>(std::ranges::count(parts, 2));
}

std::size_t count_sets(const SignedSets& sets, std::span<const std::uint8_t> counted) {
  std::size_t count = 0;
  for (std::uint32_t k = 0; k < counted.size(); ++k) {
    if (counted[k] != 0 && sets.is_first(k)) ++count;
  }
  return count;
}

/// `open`, `one_sided`: triangles at edges that have not two sides, or that reverse the winding.
void fill_parts(SignedSets& triangles, const std::vector<std::uint32_t>& open,
                const std::vector<std::uint32_t>& one_sided, std::size_t count, Parts& parts) {
  parts.first.resize(count);
  parts.turned.resize(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    const auto [first, turned] = triangles.find(t);
    parts.first[t] = first;
    parts.turned[t] = turned ? 1 : 0;
  }
  parts.is_open.assign(count, 0);
  parts.is_one_sided.assign(count, 0);
  for (const std::uint32_t t : open) parts.is_open[parts.first[t]] = 1;
  for (const std::uint32_t t : one_sided) parts.is_one_sided[parts.first[t]] = 1;
}

}  // namespace

Topology topology(const Mesh& mesh, Parts* parts) {
  const HalfEdges edges = half_edges(mesh);
  Topology result;
  SignedSets triangles(mesh.triangles.size());  // turned: their winding is opposite
  SignedSets fans(3 * mesh.triangles.size());   // corners of triangles around a point
  SignedSets points(mesh.point_count);
  SignedSets boundary(mesh.point_count);
  std::vector<std::uint8_t> on_boundary(mesh.point_count);
  std::vector<std::uint32_t> open, one_sided;  // triangles
  std::size_t edge_count = 0;
  const auto join = [&](const HalfEdge& a, const HalfEdge& b) {
    // Neighbours run along their edge in opposite directions.
    if (!triangles.join(a.triangle(), b.triangle(), a.downward == b.downward)) {
      result.orientable = false;
      one_sided.push_back(a.triangle());
    }
  };
  const auto join_fans = [&](const HalfEdge& a, const HalfEdge& b, std::uint32_t p) {
    for (const std::uint32_t end : {p, a.to}) {
      fans.join(corner_at(mesh, a.triangle(), end), corner_at(mesh, b.triangle(), end), false);
    }
  };
  for_each_pair(edges, [&](std::uint32_t p, std::span<const HalfEdge> sides) {
    const std::uint32_t to = sides[0].to;
    points.join(p, to, false);
    if (sides.size() == 2) {
      ++edge_count;
      join(sides[0], sides[1]);
      join_fans(sides[0], sides[1], p);
      return;
    }
    for (const std::vector<HalfEdge>& edge : edges_between(mesh, sides)) {
      ++edge_count;
      if (edge.size() == 1) {
        ++result.open_edges;
        open.push_back(edge[0].triangle());
        boundary.join(p, to, false);
        on_boundary[p] = on_boundary[to] = 1;
      } else if (edge.size() == 2) {
        join(edge[0], edge[1]);
        join_fans(edge[0], edge[1], p);
      } else {
        ++result.shared_edges;
        for (const HalfEdge& side : edge) {
          join_fans(edge[0], side, p);
          open.push_back(side.triangle());
        }
      }
    }
  });
  result.euler_number = static_cast<long>(mesh.point_count) - static_cast<long>(edge_count) +
                        static_cast<long>(mesh.triangles.size());
  result.components = count_sets(points, std::vector<std::uint8_t>(mesh.point_count, 1));
  result.pinched_points = count_pinched(mesh, fans);
  result.boundary_loops = count_sets(boundary, on_boundary);
  if (parts != nullptr) fill_parts(triangles, open, one_sided, mesh.triangles.size(), *parts);
  return result;
}

bool is_orientable(const Mesh& mesh, const MeshReport& report) {
  const bool reversed = report.closed_u == "reversed" || report.closed_v == "reversed";
  return !reversed || topology(mesh).orientable;
}

}  // namespace saddle
