#include "mesh/tree/singular_corners.h"

#include <algorithm>
#include <set>

#include "base/parallel.h"
#include "mesh/grid/corners.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"

namespace saddle {

namespace {

/// Sub-polygons of a leaf that have corners of their own; later ones share those of the last. A
/// leaf has at most one sub-polygon more than features.
constexpr std::size_t kMostSubPolygons = 64;

std::uint64_t key_of(std::size_t leaf, std::size_t sub_polygon, std::uint32_t vertex) {
  const std::uint64_t owner = leaf * kMostSubPolygons + std::min(sub_polygon, kMostSubPolygons - 1);
  return (owner << 32U) | vertex;
}

/// The normal of a polygon's face on its front; zero if it has no area.
dvec3 face_normal(const Grid& grid, std::span<const PolygonCorner> polygon) {
  dvec3 area(0);
  const dvec3 first = grid.local(polygon[0].corner);
  for (std::size_t k = 1; k + 1 < polygon.size(); ++k) {
    area += glm::cross(grid.local(polygon[k].corner) - first,
                       grid.local(polygon[k + 1].corner) - first);
  }
  return front_normal(grid, area);
}

dvec2 middle(const Grid& grid, std::span<const PolygonCorner> polygon) {
  dvec2 sum(0);
  for (const PolygonCorner& corner : polygon) sum += grid.mesh.uv[corner.corner];
  return sum / static_cast<double>(polygon.size());
}

/// A singular vertex as a corner of a sub-polygon.
struct View {
  std::uint32_t vertex;
  std::size_t leaf;
  std::size_t sub_polygon;  ///< index among the leaf's
  dvec3 face;               ///< the normal of its face
  dvec2 inside;             ///< parameters of its middle
};

void append_singular_views(std::span<const Leaf> leaves, std::size_t leaf, const Grid& grid,
                           const CellTree& tree, std::vector<View>& views) {
  if (!tree.geometry().singular_cells().contains(leaves[leaf])) return;
  bool is_regular = !leaves[leaf].state.is_cut_by_feature();
  for_sides(leaves[leaf], tree, [&](std::uint32_t a, std::uint32_t) {
    is_regular = is_regular && tree.geometry().is_regular(a);
  });
  if (is_regular) return;
  const std::vector<Polygon> polygons = sub_polygons(leaves[leaf], tree);
  for (std::size_t sub_polygon = 0; sub_polygon < polygons.size(); ++sub_polygon) {
    const Polygon& polygon = polygons[sub_polygon];
    for (const PolygonCorner& corner : polygon) {
      if (tree.geometry().is_regular(corner.corner)) continue;
      views.push_back(
          {corner.corner, leaf, sub_polygon, face_normal(grid, polygon), middle(grid, polygon)});
    }
  }
}

std::vector<View> singular_views(std::span<const Leaf> leaves, const Grid& grid,
                                 const CellTree& tree, unsigned threads) {
  std::vector<View> views = gather_in_chunks<View>(
      leaves.size(), kInBatch, threads, [&](std::size_t leaf, std::vector<View>& some) {
        append_singular_views(leaves, leaf, grid, tree, some);
      });
  std::ranges::stable_sort(views, {}, &View::vertex);
  return views;
}

/// Vertices at which the formula is undefined. They are singular points only if the normal has
/// several limits or none.
std::set<std::uint32_t> filled_vertices(const Surface& surface, std::span<const View> views,
                                        const Grid& grid, unsigned threads) {
  std::vector<std::uint32_t> vertices;
  std::vector<dvec2> uv;
  for (const View& view : views) {
    if (!vertices.empty() && vertices.back() == view.vertex) continue;
    vertices.push_back(view.vertex);
    uv.push_back(grid.mesh.uv[view.vertex]);
  }
  const std::vector<SurfacePoint> points = evaluate(surface, uv, threads);
  std::set<std::uint32_t> filled;
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (!is_finite(points[k].position)) filled.insert(vertices[k]);
  }
  return filled;
}

}  // namespace

const std::vector<NormalLimit>& LastLimits::find(const Surface& surface,
                                                 std::vector<Approach> approaches,
                                                 unsigned threads) {
  const auto is_same = [](const Approach& a, const Approach& b) {
    return a.corner == b.corner && a.inside == b.inside;
  };
  if (!std::ranges::equal(approaches, approaches_, is_same)) {
    limits_ = limits_in_cells(surface, approaches, threads);
    approaches_ = std::move(approaches);
  }
  return limits_;
}

SingularCorners::SingularCorners(std::span<const Leaf> leaves, const CellTree& tree,
                                 unsigned threads, LastLimits& last, Grid& grid,
                                 MeshReport& report) {
  const Surface& surface = tree.surface();
  const std::vector<View> views = singular_views(leaves, grid, tree, threads);
  std::vector<Approach> approaches;
  approaches.reserve(views.size());
  for (const View& view : views) {
    approaches.push_back({grid.mesh.uv[view.vertex], view.inside});
  }
  const std::vector<NormalLimit>& limits = last.find(surface, std::move(approaches), threads);
  const std::set<std::uint32_t> filled = filled_vertices(surface, views, grid, threads);
  VertexCorners corners(grid.mesh);
  for (std::size_t k = 0, end = 0; k < views.size(); k = end) {
    const std::uint32_t vertex = views[k].vertex;
    corners.begin(vertex);
    bool has_limits = true;
    bool has_one_normal = true;
    for (end = k; end < views.size() && views[end].vertex == vertex; ++end) {
      const View& view = views[end];
      const NormalLimit& limit = limits[end];
      const std::size_t corner = corners.find_or_add(limit.normal.value_or(view.face));
      corners_[key_of(view.leaf, view.sub_polygon, vertex)] = static_cast<std::uint32_t>(corner);
      has_limits = has_limits && limit.normal;
      has_one_normal = has_one_normal && corner == vertex;
      leaves_.push_back(view.leaf);
    }
    if (has_limits && has_one_normal && filled.contains(vertex)) continue;
    add_singular_point(grid.mesh.uv[vertex], report);
    if (!has_limits) mark_without_limit(report);
  }
  std::ranges::sort(leaves_);
  leaves_.erase(std::unique(leaves_.begin(), leaves_.end()), leaves_.end());
}

std::uint32_t SingularCorners::corner(std::size_t leaf, std::size_t sub_polygon,
                                      std::uint32_t vertex) const {
  if (corners_.empty()) return vertex;
  const auto found = corners_.find(key_of(leaf, sub_polygon, vertex));
  return found == corners_.end() ? vertex : found->second;
}

}  // namespace saddle
