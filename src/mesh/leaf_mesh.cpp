#include "mesh/leaf_mesh.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "mesh/corners.h"
#include "mesh/polygon.h"
#include "mesh/triangulate.h"
#include "surface/normal.h"

namespace saddle {

namespace {

using Polygon = std::vector<PolygonCorner>;

/// The vertices in use around a leaf, counter-clockwise in (u, v), defined or not.
Polygon outline(const Leaf& leaf, const Lattice& lattice) {
  Polygon polygon;
  const auto corners = leaf.corners();
  for (std::size_t k = 0; k < 4; ++k) {
    lattice.walk(corners[k], corners[(k + 1) % 4], [&](std::uint32_t vertex) {
      polygon.push_back({vertex, lattice.place_between(vertex)});
    });
  }
  return polygon;
}

/// What of a leaf is defined, as polygons: each run of defined vertices of its outline, and the
/// vertices on the rim at both ends.
std::vector<Polygon> pieces(const Leaf& leaf, const Lattice& lattice) {
  if (leaf.is_cut) return {};
  const Polygon whole = outline(leaf, lattice);
  const auto defined = [&](std::size_t k) { return lattice.is_defined(whole[k].corner); };
  std::size_t first = 0;  // an undefined vertex
  while (first < whole.size() && defined(first)) ++first;
  if (first == whole.size()) return {whole};
  std::vector<Polygon> result;
  for (std::size_t step = 1; step <= whole.size(); ++step) {
    const std::size_t k = (first + step) % whole.size();
    const std::size_t before = (k + whole.size() - 1) % whole.size();
    const auto add_rim = [&] {
      const std::uint32_t rim = lattice.rim(whole[before].corner, whole[k].corner);
      result.back().push_back({rim, lattice.place_between(rim)});
    };
    if (defined(k) && !defined(before)) {
      result.emplace_back();
      add_rim();
    }
    if (defined(k)) result.back().push_back(whole[k]);
    if (!defined(k) && defined(before)) add_rim();
  }
  // A piece that goes to infinity is left out.
  std::erase_if(result, [&](const Polygon& piece) {
    const auto is_far = [&](const PolygonCorner& c) { return !lattice.is_defined(c.corner); };
    return piece.size() < 3 || std::ranges::any_of(piece, is_far);
  });
  return result;
}

std::uint64_t key_of(std::size_t leaf, std::uint32_t vertex) {
  return (std::uint64_t{leaf} << 32U) | vertex;
}

/// The normal of a leaf's face on its front; zero if it has no area.
dvec3 face_normal(const Grid& grid, std::span<const PolygonCorner> polygon) {
  dvec3 area(0);
  const dvec3 first = grid.local(polygon[0].corner);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    area += glm::cross(grid.local(polygon[k].corner) - first,
                       grid.local(polygon[k + 1].corner) - first);
  }
  const double length = glm::length(area);
  if (!(length > 0)) return dvec3(0);
  return (grid.mirrored ? -area : area) / length;
}

dvec2 middle(const Grid& grid, std::span<const PolygonCorner> polygon) {
  dvec2 sum(0);
  for (const PolygonCorner& corner : polygon) sum += grid.mesh.uv[corner.corner];
  return sum / static_cast<double>(polygon.size());
}

/// A singular vertex as a leaf sees it.
struct View {
  std::uint32_t vertex;
  std::size_t leaf;
  dvec3 face;    ///< the normal of the leaf's face
  dvec2 inside;  ///< parameters in the midst of what of the leaf is defined
};

std::vector<View> singular_views(std::span<const Leaf> leaves, const Grid& grid,
                                 const Lattice& lattice) {
  std::vector<View> views;
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    for (const Polygon& polygon : pieces(leaves[leaf], lattice)) {
      for (const PolygonCorner& corner : polygon) {
        if (lattice.is_regular(corner.corner)) continue;
        views.push_back({corner.corner, leaf, face_normal(grid, polygon), middle(grid, polygon)});
      }
    }
  }
  std::ranges::stable_sort(views, {}, &View::vertex);
  return views;
}

/// Where the side of the domain that vertices lie on meets the other: the place that is one point
/// with `place`, or nothing.
std::optional<LatticePlace> partner(const Seams& seams, const Grid& grid, LatticePlace place) {
  const auto end_u = static_cast<std::uint32_t>(grid.cells_u) * kCellUnit;
  const auto end_v = static_cast<std::uint32_t>(grid.cells_v) * kCellUnit;
  if (seams.u.closed && (place.u == 0 || place.u == end_u)) {
    return LatticePlace{end_u - place.u, seams.u.partner(place.v, end_v)};
  }
  if (seams.v.closed && (place.v == 0 || place.v == end_v)) {
    return LatticePlace{seams.v.partner(place.u, end_u), end_v - place.v};
  }
  return std::nullopt;
}

/// Sides of leaves that are cut, which no line may follow.
class CutSides {
 public:
  CutSides(std::span<const Leaf> leaves, const Lattice& lattice) {
    for (const Leaf& leaf : leaves) {
      if (!leaf.is_cut) continue;
      const auto sides = sides_of(leaf, lattice);
      sides_.insert(sides.begin(), sides.end());
    }
  }
  bool contains(std::uint32_t a, std::uint32_t b) const {
    return sides_.contains({std::min(a, b), std::max(a, b)});
  }

 private:
  std::set<Side> sides_;
};

/// Chains of vertices, interrupted where the surface is.
class Chains {
 public:
  Chains(const Grid& grid, const Lattice& lattice, std::span<const Leaf> leaves)
      : point_(grid.mesh.point), lattice_(lattice), cut_(leaves, lattice) {}

  /// Goes on to the next vertex of a line, defined or not.
  void go_to(std::uint32_t vertex) {
    if (before_ && cut_.contains(*before_, vertex)) interrupt();
    if (before_ && lattice_.has_rim(*before_, vertex)) append(lattice_.rim(*before_, vertex));
    if (lattice_.is_defined(vertex)) {
      append(vertex);
    } else {
      interrupt();
    }
    before_ = vertex;
  }
  void end_line() {
    interrupt();
    before_.reset();
  }
  std::vector<std::vector<std::uint32_t>> take() { return std::move(chains_); }

 private:
  void append(std::uint32_t vertex) {
    const bool repeats = !chain_.empty() && point_[chain_.back()] == point_[vertex];
    if (!repeats) chain_.push_back(vertex);
  }
  void interrupt() {
    if (chain_.size() > 1) chains_.push_back(chain_);
    chain_.clear();
  }

  const Array<std::uint32_t>& point_;
  const Lattice& lattice_;
  CutSides cut_;
  std::optional<std::uint32_t> before_;
  std::vector<std::uint32_t> chain_;
  std::vector<std::vector<std::uint32_t>> chains_;
};

/// Index of each of the even lines among the grid's.
std::vector<std::size_t> indices(const std::vector<double>& lines, int count) {
  std::vector<std::size_t> result;
  if (count < 1) return result;
  const auto wanted =
      even_lines(lines.front(), lines.back(), static_cast<std::size_t>(std::max(count, 2) - 1));
  for (const double line : wanted) {
    result.push_back(static_cast<std::size_t>(std::ranges::find(lines, line) - lines.begin()));
  }
  if (count == 1) result.resize(1);
  return result;
}

}  // namespace

std::vector<Side> sides_of(const Leaf& leaf, const Lattice& lattice) {
  const Polygon polygon = outline(leaf, lattice);
  std::vector<Side> sides;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const std::uint32_t a = polygon[k].corner;
    const std::uint32_t b = polygon[(k + 1) % polygon.size()].corner;
    sides.push_back({std::min(a, b), std::max(a, b)});
  }
  return sides;
}

SingularCorners::SingularCorners(const Surface& surface, std::span<const Leaf> leaves,
                                 const Lattice& lattice, unsigned threads, Grid& grid,
                                 MeshReport& report) {
  const std::vector<View> views = singular_views(leaves, grid, lattice);
  std::vector<Approach> approaches;
  approaches.reserve(views.size());
  for (const View& view : views) {
    approaches.push_back({grid.mesh.uv[view.vertex], view.inside});
  }
  const std::vector<NormalLimit> limits = limit_normals(surface, approaches, threads);
  VertexCorners corners(grid.mesh);
  for (std::size_t k = 0; k < views.size(); ++k) {
    const View& view = views[k];
    if (k == 0 || views[k - 1].vertex != view.vertex) {
      corners.begin(view.vertex);
      add_singular_point(grid.mesh.uv[view.vertex], report);
    }
    report.evaluations += static_cast<std::size_t>(limits[k].evaluations);
    if (!limits[k].normal) mark_without_limit(report);
    const dvec3 normal = limits[k].normal.value_or(view.face);
    corners_[key_of(view.leaf, view.vertex)] =
        static_cast<std::uint32_t>(corners.find_or_add(normal));
    leaves_.push_back(view.leaf);
  }
  std::ranges::sort(leaves_);
  leaves_.erase(std::unique(leaves_.begin(), leaves_.end()), leaves_.end());
}

std::uint32_t SingularCorners::corner(std::size_t leaf, std::uint32_t vertex) const {
  const auto found = corners_.find(key_of(leaf, vertex));
  return found == corners_.end() ? vertex : found->second;
}

LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, const SingularCorners& singular,
                                 const Grid& grid, const Lattice& lattice) {
  LeafTriangles result;
  result.all.reserve(2 * leaves.size());
  result.first.reserve(leaves.size() + 1);
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    result.first.push_back(static_cast<std::uint32_t>(result.all.size()));
    for (Polygon& polygon : pieces(leaves[leaf], lattice)) {
      std::vector<std::uint32_t> points;
      for (PolygonCorner& corner : polygon) {
        corner.corner = singular.corner(leaf, corner.corner);
        points.push_back(grid.mesh.point[corner.corner]);
      }
      result.expected += triangles_between(points);
      if (polygon.size() == 4 && !leaves[leaf].on_rim) {
        const auto triangles = cut_cell(
            grid, {polygon[0].corner, polygon[1].corner, polygon[2].corner, polygon[3].corner});
        result.all.insert(result.all.end(), triangles.begin(), triangles.end());
      } else {
        triangulate_polygon(grid, std::move(polygon), result.all);
      }
    }
  }
  result.first.push_back(static_cast<std::uint32_t>(result.all.size()));
  return result;
}

void mirror_seams(const Seams& seams, unsigned threads, Grid& grid, Lattice& lattice) {
  // The corners of the domain may have two partners; they are root vertices, and welded.
  const std::size_t count = lattice.size();
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (auto vertex = static_cast<std::uint32_t>(grid.vertex_count()); vertex < count; ++vertex) {
    if (!lattice.is_used(vertex)) continue;
    const std::optional<LatticePlace> other = partner(seams, grid, lattice.place(vertex));
    if (!other) continue;
    const std::uint32_t twin = lattice.vertex(*other);
    lattice.use(twin);
    pairs.push_back({std::min(vertex, twin), std::max(vertex, twin)});
  }
  lattice.evaluate(threads);
  for (const auto& [first, second] : pairs) {
    grid.mesh.position[second] = grid.mesh.position[first];
    grid.mesh.point[second] = grid.mesh.point[first];
  }
}

void fit_rims(std::span<const Leaf> leaves, unsigned threads, Lattice& lattice) {
  std::vector<Side> pairs;
  std::set<Side> seen;
  for (const Leaf& leaf : leaves) {
    if (!leaf.on_rim) continue;
    for (const auto& [a, b] : sides_of(leaf, lattice)) {
      if (lattice.is_defined(a) == lattice.is_defined(b) || lattice.has_rim(a, b)) continue;
      if (seen.insert({a, b}).second) pairs.push_back({a, b});
    }
  }
  if (!pairs.empty()) lattice.fit_rims(pairs, threads);
}

void join_poles(std::span<const Leaf> leaves, const Grid& grid, Lattice& lattice) {
  for (const Leaf& leaf : leaves) {
    for (const auto& [a, b] : sides_of(leaf, lattice)) {
      if (!lattice.is_defined(a) || !lattice.is_defined(b)) continue;
      if (grid.mesh.point[a] == grid.mesh.point[b] || !is_one_point(grid, a, b)) continue;
      // The name of the point that comes first stays, whatever the order of the leaves.
      const bool a_first = grid.mesh.point[a] < grid.mesh.point[b];
      lattice.unite(a_first ? a : b, a_first ? b : a);
    }
  }
}

std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const Lattice& lattice,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v) {
  Chains chains(grid, lattice, leaves);
  const auto follow = [&](std::size_t cells, auto place_of) {
    const auto go_to = [&](std::uint32_t vertex) { chains.go_to(vertex); };
    for (std::size_t k = 0; k < cells; ++k) lattice.walk(place_of(k), place_of(k + 1), go_to);
    chains.go_to(lattice.used_vertex(place_of(cells)).value());
    chains.end_line();
  };
  const auto unit = [](std::size_t line) { return static_cast<std::uint32_t>(line) * kCellUnit; };
  for (const std::size_t i : indices(grid.u, lines_u)) {
    follow(grid.cells_v, [&](std::size_t k) { return LatticePlace{unit(i), unit(k)}; });
  }
  for (const std::size_t j : indices(grid.v, lines_v)) {
    follow(grid.cells_u, [&](std::size_t k) { return LatticePlace{unit(k), unit(j)}; });
  }
  return chains.take();
}

}  // namespace saddle
