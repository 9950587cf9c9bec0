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
  /// How many sets there are.
  std::size_t count() const {
    std::size_t count = 0;
    for (std::size_t a = 0; a < parent_.size(); ++a) count += parent_[a] == a ? 1 : 0;
    return count;
  }
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

/// The parts that the triangles at a point make, which share edges there.
class Fans {
 public:
  /// Every corner is a part of its own. `corners`: of triangles at the point, in order.
  void start(std::span<const std::uint32_t> corners) {
    corners_ = corners;
    next_.resize(corners.size());
    std::iota(next_.begin(), next_.end(), std::size_t{0});
  }
  void join(std::uint32_t triangle, std::uint32_t other) {
    next_[part_of(place_of(other))] = part_of(place_of(triangle));
  }
  std::size_t count() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < next_.size(); ++i) count += next_[i] == i ? 1 : 0;
    return count;
  }

 private:
  /// The first corner of a triangle; one without an area may have several at a point.
  std::size_t place_of(std::uint32_t triangle) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(corners_, 3 * triangle) -
                                    corners_.begin());
  }
  std::size_t part_of(std::size_t i) const {
    while (next_[i] != i) i = next_[i];
    return i;
  }
  std::span<const std::uint32_t> corners_;
  std::vector<std::size_t> next_;  ///< in the same part; itself: it stands for the part
};

/// The parts of edges that share no point.
std::size_t count_loops(const std::vector<IndexPair>& edges) {
  std::vector<std::uint32_t> points;
  for (const auto& [a, b] : edges) points.insert(points.end(), {a, b});
  std::ranges::sort(points);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  const auto place = [&](std::uint32_t point) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(points, point) - points.begin());
  };
  SignedSets sets(points.size());
  for (const auto& [a, b] : edges) sets.join(place(a), place(b), false);
  return sets.count();
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

/// Goes from point to point, so that no list of all edges is needed.
class TopologyFinder {
 public:
  explicit TopologyFinder(const Mesh& mesh)
      : mesh_(mesh), triangles_(mesh.triangles.size()), points_(mesh.point_count) {}

  Topology find() {
    const CornersOfPoints corners = corners_of_points(mesh_);
    std::vector<HalfEdge> sides;
    for (std::uint32_t p = 0; p < mesh_.point_count; ++p) {
      fans_.start(corners.of(p));
      find_sides(mesh_, corners.of(p), sides);
      for_each_neighbour(sides, [&](std::span<const HalfEdge> shared) { add(p, shared); });
      if (fans_.count() > 1) ++result_.pinched_points;
    }
    result_.euler_number = static_cast<long>(mesh_.point_count) - static_cast<long>(edges_) +
                           static_cast<long>(mesh_.triangles.size());
    result_.components = points_.count();
    result_.open_edges = boundary_.size();
    result_.boundary_loops = count_loops(boundary_);
    return result_;
  }

  void fill(Parts& parts) {
    fill_parts(triangles_, open_, one_sided_, mesh_.triangles.size(), parts);
  }

 private:
  void add(std::uint32_t p, std::span<const HalfEdge> sides) {
    if (sides.size() == 2) {
      add_edge(p, sides);
    } else {
      for (const std::vector<HalfEdge>& edge : edges_between(mesh_, sides)) add_edge(p, edge);
    }
  }

  /// Both ends see an edge and have fans; all else is done at the smaller one.
  void add_edge(std::uint32_t p, std::span<const HalfEdge> edge) {
    for (const HalfEdge& side : edge.subspan(1)) fans_.join(edge[0].triangle(), side.triangle());
    const std::uint32_t to = edge[0].to;
    if (to < p) return;
    ++edges_;
    points_.join(p, to, false);
    if (edge.size() == 1) {
      open_.push_back(edge[0].triangle());
      boundary_.emplace_back(p, to);
    } else if (edge.size() == 2) {
      // Neighbours run along their edge in opposite directions.
      const bool turned = edge[0].arrives == edge[1].arrives;
      if (triangles_.join(edge[0].triangle(), edge[1].triangle(), turned)) return;
      result_.orientable = false;
      one_sided_.push_back(edge[0].triangle());
    } else {
      ++result_.shared_edges;
      for (const HalfEdge& side : edge) open_.push_back(side.triangle());
    }
  }

  const Mesh& mesh_;
  Topology result_;
  SignedSets triangles_;  ///< turned: their winding is opposite
  SignedSets points_;
  Fans fans_;
  std::vector<IndexPair> boundary_;              ///< ends of open edges
  std::vector<std::uint32_t> open_, one_sided_;  ///< triangles
  std::size_t edges_ = 0;
};

}  // namespace

bool Parts::turn_over() const {
  return std::ranges::any_of(turned, [](std::uint8_t is_turned) { return is_turned != 0; });
}

Topology topology(const Mesh& mesh, Parts* parts) {
  TopologyFinder finder(mesh);
  const Topology result = finder.find();
  if (parts != nullptr) finder.fill(*parts);
  return result;
}

bool is_orientable(const Mesh& mesh, const MeshReport& report) {
  const bool reversed = report.closed_u == "reversed" || report.closed_v == "reversed";
  return !reversed || topology(mesh).orientable;
}

}  // namespace saddle
