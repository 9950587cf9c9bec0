#include "mesh/model/topology.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

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

/// Two points or corners, in order.
using IndexPair = std::pair<std::uint32_t, std::uint32_t>;

/// A side of a triangle, without the smaller one of its points.
struct HalfEdge {
  std::uint32_t to;  ///< the larger point
  std::uint32_t triangle;
  bool downward;  ///< the triangle runs from the larger to the smaller point
};

/// All sides of triangles, sorted by their smaller and then by their larger point. Sides whose
/// smaller point is p begin at `begin[p]`.
struct HalfEdges {
  std::vector<std::size_t> begin;
  std::vector<HalfEdge> all;
};

template <class F>
void for_each_side(const Mesh& mesh, F f) {
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = mesh.point[mesh.triangles[t][k]];
      const std::uint32_t b = mesh.point[mesh.triangles[t][(k + 1) % 3]];
      f(std::min(a, b), HalfEdge{std::max(a, b), t, a > b});
    }
  }
}

HalfEdges half_edges(const Mesh& mesh) {
  HalfEdges edges;
  edges.begin.resize(mesh.point_count + 1);
  for_each_side(mesh, [&](std::uint32_t point, const HalfEdge&) { ++edges.begin[point + 1]; });
  std::partial_sum(edges.begin.begin(), edges.begin.end(), edges.begin.begin());
  edges.all.resize(edges.begin.back());
  std::vector<std::size_t> next(edges.begin.begin(), edges.begin.end() - 1);
  for_each_side(
      mesh, [&](std::uint32_t point, const HalfEdge& side) { edges.all[next[point]++] = side; });
  for (std::size_t p = 0; p < mesh.point_count; ++p) {
    std::sort(edges.all.begin() + static_cast<std::ptrdiff_t>(edges.begin[p]),
              edges.all.begin() + static_cast<std::ptrdiff_t>(edges.begin[p + 1]),
              [](const HalfEdge& a, const HalfEdge& b) { return a.to < b.to; });
  }
  return edges;
}

/// The corners at the ends of a triangle's side between two points, in order.
IndexPair corners_of(const Mesh& mesh, const HalfEdge& side, const IndexPair& points) {
  const Triangle& t = mesh.triangles[side.triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const IndexPair ends = std::minmax(mesh.point[t[k]], mesh.point[t[(k + 1) % 3]]);
    if (ends == points) return std::minmax(t[k], t[(k + 1) % 3]);
  }
  return {};
}

/// The sides between two points, parted into edges. Two sides with the same corners are an edge of
/// their own: leaves around a point may have chords to the same neighbour, which lie on each other.
std::vector<std::vector<HalfEdge>> edges_between(const Mesh& mesh, const IndexPair& points,
                                                 std::span<const HalfEdge> sides) {
  if (sides.size() == 1) return {{sides[0]}};
  std::map<IndexPair, std::vector<HalfEdge>> by_corners;
  for (const HalfEdge& side : sides) by_corners[corners_of(mesh, side, points)].push_back(side);
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
    if (!triangles.join(a.triangle, b.triangle, a.downward == b.downward)) {
      result.orientable = false;
      one_sided.push_back(a.triangle);
    }
  };
  const auto join_fans = [&](const HalfEdge& a, const HalfEdge& b, std::uint32_t p) {
    for (const std::uint32_t end : {p, a.to}) {
      fans.join(corner_at(mesh, a.triangle, end), corner_at(mesh, b.triangle, end), false);
    }
  };
  for (std::uint32_t p = 0; p < mesh.point_count; ++p) {
    for (std::size_t first = edges.begin[p], last = first; first < edges.begin[p + 1];
         first = last) {
      const std::uint32_t to = edges.all[first].to;
      while (last < edges.begin[p + 1] && edges.all[last].to == to) ++last;
      points.join(p, to, false);
      const std::span<const HalfEdge> sides = std::span(edges.all).subspan(first, last - first);
      if (sides.size() == 2) {
        ++edge_count;
        join(sides[0], sides[1]);
        join_fans(sides[0], sides[1], p);
        continue;
      }
      for (const std::vector<HalfEdge>& edge : edges_between(mesh, {p, to}, sides)) {
        ++edge_count;
        if (edge.size() == 1) {
          ++result.open_edges;
          open.push_back(edge[0].triangle);
          boundary.join(p, to, false);
          on_boundary[p] = on_boundary[to] = 1;
        } else if (edge.size() == 2) {
          join(edge[0], edge[1]);
          join_fans(edge[0], edge[1], p);
        } else {
          ++result.shared_edges;
          for (const HalfEdge& side : edge) {
            join_fans(edge[0], side, p);
            open.push_back(side.triangle);
          }
        }
      }
    }
  }
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
