#include "mesh/grid/weld.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "mesh/features/removable.h"
#include "mesh/model/point_union.h"
#include "mesh/model/tolerances.h"

namespace saddle {

namespace {

/// Vertices within kSame are one point only if they are also closer than this part of the
/// grid's steps beside them.
/// Otherwise the extent of a spike, as of tan near its pole (1e16), would weld all of a surface.
constexpr double kJoinStep = 1e-3;

/// Whether all of a box (in local units) is one point: by kSame, or within rounding. Each
/// coordinate has its own extent: heights of 1e9 do not weld vertices that are apart in x.
bool is_one_point(const Grid& grid, const Bounds& box) {
  const dvec3 least = rounding_of(glm::max(glm::abs(box.low), glm::abs(box.high)));
  const dvec3 tolerance = kSame * grid.local_scale * grid.mesh.bounds.size();
  return glm::all(glm::lessThanEqual(box.size(), glm::max(least, tolerance)));
}

/// The distance of two vertices; 0 if one is not used.
double distance(const Grid& grid, std::size_t a, std::size_t b) {
  if (!grid.is_used(a) || !grid.is_used(b)) return 0;
  return glm::distance(grid.local(a), grid.local(b));
}

/// Counts the pairs of vertices with a gap that is short beside a step of the grid. The majority
/// decides: a spike or a fold beside a few pairs does not.
class Majority {
 public:
  void add(double gap, double step) {
    ++pairs_;
    if (gap <= kJoinStep * step) ++short_gaps_;
  }
  bool has_short_gaps() const { return 2 * short_gaps_ > pairs_; }

 private:
  std::size_t pairs_ = 0;
  std::size_t short_gaps_ = 0;
};

/// Whether line k is a single point: a line that is short beside its neighbours.
bool is_pole(const Grid& grid, std::span<const GridLine> lines, std::size_t k) {
  const GridLine& line = lines[k];
  Bounds bounds;
  for (std::size_t m = 0; m < line.count; ++m) {
    if (!grid.is_used(line[m])) continue;
    bounds.add(grid.local(line[m]));
    if (!is_one_point(grid, bounds)) return false;  // most lines end here, after two vertices
  }
  Majority majority;
  for (std::size_t m = 0; m + 1 < line.count; ++m) {
    if (!grid.is_used(line[m]) || !grid.is_used(line[m + 1])) continue;
    const auto step = [&](const GridLine& beside) {
      return distance(grid, beside[m], beside[m + 1]);
    };
    const double before = k > 0 ? step(lines[k - 1]) : 0;
    const double after = k + 1 < lines.size() ? step(lines[k + 1]) : 0;
    majority.add(step(line), std::max(before, after));
  }
  return majority.has_short_gaps();
}

/// The most by which rounding of the parameters moves vertices, in local units.
std::vector<dvec3> rounding_by_parameters(const Surface& surface, const Grid& grid,
                                          std::span<const std::size_t> vertices, unsigned threads) {
  std::vector<dvec2> uv;
  for (const std::size_t vertex : vertices) uv.push_back(grid.mesh.uv[vertex]);
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  std::vector<dvec3> moved;
  for (std::size_t k = 0; k < points.size(); ++k) {
    moved.push_back(grid.local_scale *
                    saddle::rounding_by_parameters(points[k], uv[k], surface.domain));
  }
  return moved;
}

/// The vertices of a line, if rounding of the parameters alone may keep them apart: the boxes in
/// which rounding leaves them have a place in common.
std::vector<std::size_t> rounded_pole(const Surface& surface, const Grid& grid,
                                      const GridLine& line, unsigned threads) {
  std::vector<std::size_t> vertices;
  Bounds bounds;
  for (std::size_t m = 0; m < line.count; ++m) {
    if (!grid.is_used(line[m])) continue;
    vertices.push_back(line[m]);
    bounds.add(grid.local(line[m]));
    if (bounds.diagonal() > kMostRounding * grid.diagonal) return {};
  }
  Bounds common;
  const std::vector<dvec3> moved = rounding_by_parameters(surface, grid, vertices, threads);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    const dvec3 place = grid.local(vertices[k]);
    const dvec3 reach = moved[k] + rounding_of(place);
    common.low = k > 0 ? glm::max(common.low, place - reach) : place - reach;
    common.high = k > 0 ? glm::min(common.high, place + reach) : place + reach;
    if (glm::any(glm::greaterThan(common.low, common.high))) return {};
  }
  return vertices;
}

/// Makes each line that is one point exactly one.
void collapse_poles(const Surface& surface, unsigned threads, Grid& grid,
                    std::span<const GridLine> lines) {
  for (std::size_t k = 0; k < lines.size(); ++k) {
    std::optional<dvec3> pole;
    if (!is_pole(grid, lines, k)) {
      Bounds bounds;
      for (const std::size_t vertex : rounded_pole(surface, grid, lines[k], threads))
        bounds.add(grid.mesh.position[vertex]);
      if (bounds.empty()) continue;
      pole = bounds.centre();
    }
    for (std::size_t m = 0; m < lines[k].count; ++m) {
      const std::size_t vertex = lines[k][m];
      if (!grid.is_used(vertex)) continue;
      dvec3& position = grid.mesh.position[vertex];
      if (!pole) pole = position;
      position = *pole;
      grid.open_around(vertex);
    }
  }
}

/// Two opposite edges of the domain.
struct EdgePair {
  GridLine first;
  GridLine after_first;  ///< the line of the grid next to it
  GridLine last;

  /// The vertex on the last edge that sample k of the first meets.
  std::size_t partner(std::size_t k, const Seam& seam) const {
    return last[seam.partner(k, last.count - 1)];
  }
};

/// Whether the edges meet at every sample where the surface is defined, and are defined alike.
bool edges_meet(const Surface& surface, const Grid& grid, const EdgePair& edges, const Seam& seam) {
  const std::size_t cells = edges.last.count - 1;
  if (cells % seam.shift.of != 0) return false;  // a shifted vertex is none
  Majority majority;
  for (std::size_t k = 0; k < edges.first.count; ++k) {
    const std::size_t a = edges.first[k];
    const std::size_t b = edges.partner(k, seam);
    if (!grid.is_used(a) && !grid.is_used(b)) continue;
    if (!grid.is_used(a) || !grid.is_used(b)) return false;
    const bool is_near = is_one_point(grid, a, b);
    if (!is_near && !is_one_point(surface, grid, a, b)) return false;
    majority.add(is_near ? distance(grid, a, b) : 0, distance(grid, a, edges.after_first[k]));
  }
  return majority.has_short_gaps();
}

/// Unites the vertices of two edges that meet.
void unite(Grid& grid, const EdgePair& edges, const Seam& seam, PointUnion& points) {
  for (std::size_t k = 0; k < edges.first.count; ++k) {
    const std::size_t a = edges.first[k];
    const std::size_t b = edges.partner(k, seam);
    if (!grid.is_used(a)) continue;
    grid.mesh.position[b] = grid.mesh.position[a];
    points.unite(a, b);
    if (edges.last.first == edges.after_first.first) grid.open_around(a);  // one cell across
  }
}

/// Whether the surface goes on across a seam without a crease, wherever its normals are known.
bool goes_on_smoothly(const Grid& grid, const EdgePair& edges, const Seam& seam) {
  for (std::size_t k = 0; k < edges.first.count; ++k) {
    const dvec3& first = grid.mesh.normal[edges.first[k]];
    const dvec3& last = grid.mesh.normal[edges.partner(k, seam)];
    if (glm::length(glm::cross(first, last)) > kClose) return false;  // not so for NaN
  }
  return true;
}

/// Unites the vertices of two edges that meet. Returns how they meet. An edge that lies on itself
/// meets another both ways: the surface goes on along one of them.
Seam join_edges(const Surface& surface, Grid& grid, const EdgePair& edges, PointUnion& points) {
  Seam found;
  for (const Seam& seam : kSeams) {
    if (!edges_meet(surface, grid, edges, seam)) continue;
    const bool is_smooth = goes_on_smoothly(grid, edges, seam);
    if (is_smooth || !found.closed) found = seam;
    if (is_smooth) break;
  }
  if (found.closed) unite(grid, edges, found, points);
  return found;
}

/// Unites the halves of an edge that is folded and no point. Its middle is a vertex, or a side of
/// its middle cell becomes a point.
bool fold_edge(const Surface& surface, Grid& grid, const GridLine& edge, const GridLine& beside,
               PointUnion& points) {
  Bounds bounds;
  for (std::size_t k = 0; k < edge.count; ++k) {
    if (grid.is_used(edge[k])) bounds.add(grid.local(edge[k]));
  }
  const EdgePair halves{edge, beside, edge};
  if (is_one_point(grid, bounds) || !edges_meet(surface, grid, halves, kFold)) return false;
  unite(grid, halves, kFold, points);
  if (edge.count % 2 == 0) grid.open_around(edge[edge.count / 2]);
  return true;
}

/// Unites neighbours at the same place if the surface between them stays there. A cell beside them
/// is not plain, so it is open.
void join_equal_neighbours(const Surface& surface, unsigned threads, const Grid& grid,
                           PointUnion& points) {
  std::vector<Neighbours> sides;
  for (std::size_t cell = 0; cell < grid.cell_count(); ++cell) {
    if (grid.cells[cell] != GridCell::Open) continue;
    const auto vertices = grid.vertices(cell);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t a = vertices[k];
      const std::size_t b = vertices[(k + 1) % 4];
      if (grid.mesh.position[a] != grid.mesh.position[b]) continue;
      sides.push_back({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
    }
  }
  for (const auto& [a, b] : collapsed(surface, grid, sides, threads)) points.unite(a, b);
}

/// Whether two places, in local units, are one within rounding and within the error of sin(2 pi).
/// `moved`: by rounding of their parameters.
bool is_one_place(const Grid& grid, const dvec3& p, const dvec3& q, const dvec3& moved = dvec3(0)) {
  for (int k = 0; k < 3; ++k) {  // most are apart in the first
    const double gap = std::fabs(p[k] - q[k]);
    const double least = std::max(moved[k], kRounding * std::max(std::fabs(p[k]), std::fabs(q[k])));
    const double size = grid.mesh.bounds.high[k] - grid.mesh.bounds.low[k];
    if (gap > std::max(least, kSame * grid.local_scale * size)) return false;
  }
  return true;
}

}  // namespace

bool is_one_point(const Grid& grid, std::size_t a, std::size_t b) {
  return is_one_place(grid, grid.local(a), grid.local(b));
}

bool is_one_point(const Surface& surface, const Grid& grid, std::size_t a, std::size_t b) {
  if (is_one_point(grid, a, b)) return true;
  const dvec3 p = grid.local(a);
  const dvec3 q = grid.local(b);
  if (!(glm::distance(p, q) <= kMostRounding * grid.diagonal)) return false;
  const std::vector<dvec3> moved = rounding_by_parameters(surface, grid, std::array{a, b}, 1);
  return is_one_place(grid, p, q, moved[0] + moved[1]);
}

bool is_short_beside(const Grid& grid, std::size_t a, std::size_t b, double length) {
  const dvec3 p = grid.local(a);
  const dvec3 q = grid.local(b);
  return glm::distance(p, q) <= kJoinStep * length ||
         glm::all(
             glm::lessThanEqual(glm::abs(p - q), rounding_of(glm::max(glm::abs(p), glm::abs(q)))));
}

std::vector<Neighbours> collapsed(const Surface& surface, const Grid& grid,
                                  std::span<const Neighbours> sides, unsigned threads) {
  const auto& uv = grid.mesh.uv;
  std::vector<dvec2> middles;
  middles.reserve(sides.size());
  for (const auto& [a, b] : sides) middles.push_back(0.5 * uv[a] + 0.5 * uv[b]);
  const std::vector<SurfacePoint> points = evaluate(surface, middles, threads);
  std::vector<Neighbours> result;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const dvec3 middle = grid.local_scale * points[k].position;
    // An undefined middle does not keep its ends apart.
    const dvec3 moved =
        grid.local_scale * saddle::rounding_by_parameters(points[k], middles[k], surface.domain);
    const bool stays =
        !is_finite(middle) || is_one_place(grid, middle, grid.local(sides[k][0]), moved);
    if (stays) result.push_back(sides[k]);
  }
  return result;
}

Seams weld(const Surface& surface, unsigned threads, Grid& grid) {
  std::vector<GridLine> columns;
  std::vector<GridLine> rows;
  for (std::size_t i = 0; i <= grid.cells_u; ++i) columns.push_back(grid.column(i));
  for (std::size_t j = 0; j <= grid.cells_v; ++j) rows.push_back(grid.row(j));
  const std::size_t nu = grid.cells_u;
  const std::size_t nv = grid.cells_v;

  PointUnion points(grid.mesh);
  Seams seams;
  collapse_poles(surface, threads, grid, columns);
  collapse_poles(surface, threads, grid, rows);
  seams.u = join_edges(surface, grid, {columns[0], columns[1], columns[nu]}, points);
  seams.v = join_edges(surface, grid, {rows[0], rows[1], rows[nv]}, points);
  if (!seams.u.closed) {
    seams.folded_u = {fold_edge(surface, grid, columns[0], columns[1], points),
                      fold_edge(surface, grid, columns[nu], columns[nu - 1], points)};
  }
  if (!seams.v.closed) {
    seams.folded_v = {fold_edge(surface, grid, rows[0], rows[1], points),
                      fold_edge(surface, grid, rows[nv], rows[nv - 1], points)};
  }
  join_equal_neighbours(surface, threads, grid, points);
  points.settle();
  return seams;
}

void report_seams(const Seams& seams, MeshReport& report) {
  report.closed_u = seams.u.name();
  report.closed_v = seams.v.name();
  report.shift_u = seams.u.shift;
  report.shift_v = seams.v.shift;
  report.folded_u = seams.folded_u;
  report.folded_v = seams.folded_v;
}

}  // namespace saddle
