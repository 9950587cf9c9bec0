#include "mesh/weld.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <glm/vector_relational.hpp>

namespace saddle {

namespace {

/// Vertices closer than this part of the diagonal may be one point: some digits more than sin(2 pi)
/// and its like lose, and far below what a float or a picture shows.
constexpr double kJoinFraction = 1e-9;
/// They are one point only if they are also this much closer than the grid's steps beside them. It
/// keeps a surface apart whose diagonal is that of a spike (tan near its pole: 1e16).
constexpr double kJoinStep = 1e-3;

/// Sets with the smallest member as the name of each.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t find(std::uint32_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void unite(std::size_t a, std::size_t b) {
    const std::uint32_t root_a = find(static_cast<std::uint32_t>(a));
    const std::uint32_t root_b = find(static_cast<std::uint32_t>(b));
    parent_[std::max(root_a, root_b)] = std::min(root_a, root_b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Whether all of a box (in local units) is one point: by the tolerance, or within rounding.
bool is_one_point(const Grid& grid, const Bounds& box) {
  const dvec3 least = rounding(glm::max(glm::abs(box.low), glm::abs(box.high)));
  const double tolerance = kJoinFraction * grid.diagonal;
  return glm::all(glm::lessThanEqual(box.size(), glm::max(least, tolerance)));
}

/// The distance of two vertices; 0 if one is not used.
double distance(const Grid& grid, std::size_t a, std::size_t b) {
  if (!grid.vertex_used[a] || !grid.vertex_used[b]) return 0;
  return glm::distance(grid.local(a), grid.local(b));
}

/// Counts for how many pairs of vertices the gap between them is short beside a step of the grid.
/// The majority decides, so that neither a spike nor a fold beside a few of them does.
class Majority {
 public:
  void add(double gap, double step) {
    ++pairs_;
    if (gap <= kJoinStep * step) ++short_gaps_;
  }
  bool says_one_point() const { return 2 * short_gaps_ > pairs_; }

 private:
  std::size_t pairs_ = 0;
  std::size_t short_gaps_ = 0;
};

/// Whether line k is a single point: a line that is short beside its neighbours.
bool is_pole(const Grid& grid, std::span<const GridLine> lines, std::size_t k) {
  const GridLine& line = lines[k];
  Bounds bounds;
  for (std::size_t m = 0; m < line.count; ++m) {
    if (!grid.vertex_used[line[m]]) continue;
    bounds.add(grid.local(line[m]));
    if (!is_one_point(grid, bounds)) return false;  // most lines end here, after two vertices
  }
  Majority majority;
  for (std::size_t m = 0; m + 1 < line.count; ++m) {
    if (!grid.vertex_used[line[m]] || !grid.vertex_used[line[m + 1]]) continue;
    const auto step = [&](const GridLine& beside) {
      return distance(grid, beside[m], beside[m + 1]);
    };
    const double before = k > 0 ? step(lines[k - 1]) : 0;
    const double after = k + 1 < lines.size() ? step(lines[k + 1]) : 0;
    majority.add(step(line), std::max(before, after));
  }
  return majority.says_one_point();
}

/// Makes each line that is one point exactly one.
void collapse_poles(Grid& grid, std::span<const GridLine> lines) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (!is_pole(grid, lines, k)) continue;
    const dvec3* pole = nullptr;
    for (std::size_t m = 0; m < lines[k].count; ++m) {
      if (!grid.vertex_used[lines[k][m]]) continue;
      dvec3& position = grid.points[lines[k][m]].position;
      if (!pole) pole = &position;
      position = *pole;
    }
  }
}

/// Two opposite edges of the domain.
struct EdgePair {
  GridLine first;
  GridLine after_first;  ///< the line of the grid next to it
  GridLine last;

  /// The vertex on the last edge that sample k of the first meets.
  std::size_t partner(std::size_t k, bool reversed) const {
    return last[reversed ? last.count - 1 - k : k];
  }
};

/// Whether the edges meet at every sample where the surface is defined, and are defined alike.
bool edges_meet(const Grid& grid, const EdgePair& edges, bool reversed) {
  Majority majority;
  for (std::size_t k = 0; k < edges.first.count; ++k) {
    const std::size_t a = edges.first[k];
    const std::size_t b = edges.partner(k, reversed);
    if (!grid.vertex_used[a] && !grid.vertex_used[b]) continue;
    if (!grid.vertex_used[a] || !grid.vertex_used[b]) return false;
    Bounds gap;
    gap.add(grid.local(a));
    gap.add(grid.local(b));
    if (!is_one_point(grid, gap)) return false;
    majority.add(distance(grid, a, b), distance(grid, a, edges.after_first[k]));
  }
  return majority.says_one_point();
}

/// Unites the vertices of two edges that meet; says how they meet.
std::string join_edges(Grid& grid, const EdgePair& edges, DisjointSets& sets) {
  for (const bool reversed : {false, true}) {
    if (!edges_meet(grid, edges, reversed)) continue;
    for (std::size_t k = 0; k < edges.first.count; ++k) {
      const std::size_t a = edges.first[k];
      const std::size_t b = edges.partner(k, reversed);
      if (!grid.vertex_used[a]) continue;
      grid.points[b].position = grid.points[a].position;
      sets.unite(a, b);
    }
    return reversed ? "reversed" : "join";
  }
  return "";
}

/// Neighbours at the same place are one point.
void join_equal_neighbours(const Grid& grid, std::span<const GridLine> lines, DisjointSets& sets) {
  for (const GridLine& line : lines) {
    for (std::size_t k = 1; k < line.count; ++k) {
      const std::size_t a = line[k - 1];
      const std::size_t b = line[k];
      if (!grid.vertex_used[a] || !grid.vertex_used[b]) continue;
      if (grid.points[a].position == grid.points[b].position) sets.unite(a, b);
    }
  }
}

}  // namespace

Joints weld(Grid& grid) {
  std::vector<GridLine> columns;
  std::vector<GridLine> rows;
  for (std::size_t i = 0; i <= grid.cells_u; ++i) columns.push_back(grid.column(i));
  for (std::size_t j = 0; j <= grid.cells_v; ++j) rows.push_back(grid.row(j));
  const std::size_t nu = grid.cells_u;
  const std::size_t nv = grid.cells_v;

  DisjointSets sets(grid.points.size());
  Joints joints;
  collapse_poles(grid, columns);
  collapse_poles(grid, rows);
  joints.closed_u = join_edges(grid, {columns[0], columns[1], columns[nu]}, sets);
  joints.closed_v = join_edges(grid, {rows[0], rows[1], rows[nv]}, sets);
  join_equal_neighbours(grid, columns, sets);
  join_equal_neighbours(grid, rows, sets);

  joints.point.resize(grid.points.size());
  for (std::uint32_t vertex = 0; vertex < joints.point.size(); ++vertex) {
    joints.point[vertex] = sets.find(vertex);
    grid.points[vertex].position = grid.points[joints.point[vertex]].position;
  }
  return joints;
}

}  // namespace saddle
