#include "mesh/tree/leaf_mesh.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include "mesh/grid/cell_loops.h"
#include "mesh/grid/corners.h"
#include "mesh/grid/triangulate.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/model/parameter_box.h"
#include "mesh/tree/polygon.h"

namespace saddle {

namespace {

/// A leaf has at most one piece more than crossings, of which more than a few are cut no further.
constexpr std::size_t kMostSubPolygons = 64;

std::uint64_t key_of(std::size_t leaf, std::size_t sub_polygon, std::uint32_t vertex) {
  const std::uint64_t owner = leaf * kMostSubPolygons + std::min(sub_polygon, kMostSubPolygons - 1);
  return (owner << 32U) | vertex;
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
  std::size_t sub_polygon;  ///< which of the leaf's
  dvec3 face;               ///< the normal of the leaf's face
  dvec2 inside;             ///< parameters in the midst of what of the leaf is defined
};

std::vector<View> singular_views(std::span<const Leaf> leaves, const Grid& grid,
                                 const CellTree& tree) {
  std::vector<View> views;
  if (!tree.geometry().has_singular()) return views;
  const CellMarks& singular_cells = tree.geometry().singular_cells();
  for (std::size_t leaf = 0; leaf < leaves.size(); ++leaf) {
    const bool is_cut = leaves[leaf].state.is_cut_by_feature();
    if (!is_cut && !singular_cells.contains(leaves[leaf])) continue;
    bool is_regular = !is_cut;
    for_sides(leaves[leaf], tree, [&](std::uint32_t a, std::uint32_t) {
      is_regular = is_regular && tree.geometry().is_regular(a);
    });
    if (is_regular) continue;
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
  std::ranges::stable_sort(views, {}, &View::vertex);
  return views;
}

/// Vertices at which the surface is not defined but has a limit: singular only if its normal has
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

constexpr std::uint32_t kNoCell = 0xffffffff;

/// The cell of the root grid that a plain leaf is, if that has been cut when it was sampled.
std::uint32_t cell_cut_before(const Leaf& leaf, const std::array<std::uint32_t, 4>& corners,
                              const Grid& grid, const CellTree& tree) {
  if (leaf.size_u() != kCellUnit || leaf.size_v() != kCellUnit) return kNoCell;
  const std::size_t cell = grid.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit);
  const bool is_cut =
      grid.cells[cell] == GridCell::Two && std::ranges::all_of(corners, [&](std::uint32_t corner) {
        return tree.geometry().is_regular(corner);
      });
  return is_cut ? static_cast<std::uint32_t>(cell) : kNoCell;
}

/// Leaves of four corners, cut as cells of a grid are: many at a time, the plain ones at once.
class PlainCutter {
 public:
  explicit PlainCutter(const Grid& grid) : grid_(grid) {}

  void add(const std::array<std::uint32_t, 4>& corners) {
    cells_.push_back(kNoCell);
    corners_.push_back(corners);
    if (corners_.size() % kBlock == 0) cut();
  }
  /// Adds a leaf that is a cell of the root grid, which is cut already.
  void add_cut(std::uint32_t cell) { cells_.push_back(cell); }
  void finish() {
    if (cuts_.size() < corners_.size()) cut();
  }

  /// Appends the triangles of the next leaf; returns how many there would be if none were without
  /// area.
  std::size_t take(Array<Triangle>& triangles) {
    const std::uint32_t cell = cells_[taken_++];
    if (cell != kNoCell) {
      for (const Triangle& triangle : grid_.triangles(cell)) triangles.push_back(triangle);
      return 2;
    }
    const auto& c = corners_[taken_corners_];
    const Way way = cuts_[taken_corners_++];
    if (way == Way::Unknown) {
      std::vector<std::uint32_t> points;
      for (const std::uint32_t corner : c) points.push_back(grid_.mesh.point[corner]);
      cut_cell(grid_, c, triangles);
      return triangles_between(points);
    }
    const bool second = way == Way::Second;
    const std::array<std::uint32_t, 4> from = {c[second ? 1 : 0], c[second ? 2 : 1],
                                               c[second ? 3 : 2], c[second ? 0 : 3]};
    const std::size_t turn = grid_.mirrored ? 1 : 0;
    for (const Triangle& t :
         {Triangle{from[0], from[1], from[2]}, Triangle{from[2], from[3], from[0]}}) {
      triangles.push_back({t[0], t[1 + turn], t[2 - turn]});
    }
    return 2;
  }

 private:
  enum class Way : std::uint8_t { First, Second, Unknown };
  /// Each takes two vertices of a strip: the cells between leaves are for nothing.
  static constexpr std::size_t kBlock = kTileCells / 2;
  using Strips = std::array<Strip, 2>;

  void put(std::uint32_t corner, std::size_t i, Strip& strip) const {
    const dvec3& position = grid_.mesh.position[corner];
    put_vertex(position, grid_.mesh.normal[corner], i, strip);
    const double size =
        std::max({std::fabs(position.x), std::fabs(position.y), std::fabs(position.z)});
    strip.size = std::max(strip.size, size);
  }

  void cut() {
    auto& [lower, upper] = *strips_;
    lower.size = upper.size = 0;
    const std::size_t first = cuts_.size();
    const std::size_t count = corners_.size() - first;
    for (std::size_t i = 0; i < count; ++i) {
      const auto& corners = corners_[first + i];
      put(corners[0], 2 * i, lower);
      put(corners[1], 2 * i + 1, lower);
      put(corners[2], 2 * i + 1, upper);
      put(corners[3], 2 * i, upper);
    }
    cell_loop(cpu_level())(lower, upper, 2 * count - 1, grid_.mirrored ? -1 : 1, *found_);
    for (std::size_t i = 0; i < count; ++i) {
      const Way way = found_->second[2 * i] > 0 ? Way::Second : Way::First;
      cuts_.push_back(found_->margin[2 * i] > 0 ? way : Way::Unknown);
    }
  }

  const Grid& grid_;
  std::vector<std::uint32_t> cells_;  // of all leaves; kNoCell: the next of the corners
  std::vector<std::array<std::uint32_t, 4>> corners_;
  std::vector<Way> cuts_;
  std::size_t taken_ = 0;
  std::size_t taken_corners_ = 0;
  std::unique_ptr<Strips> strips_ = std::make_unique_for_overwrite<Strips>();
  std::unique_ptr<Cuts> found_ = std::make_unique_for_overwrite<Cuts>();
};

/// Chains of vertices, interrupted where the surface is.
class Chains {
 public:
  Chains(const Grid& grid, const CellTree& tree, std::span<const Leaf> leaves)
      : point_(grid.mesh.point), tree_(tree) {
    for (const Leaf& leaf : leaves) {
      if (!leaf.state.oscillates()) continue;
      for_sides(leaf, tree,
                [this](std::uint32_t a, std::uint32_t b) { oscillating_.insert(pair_of(a, b)); });
    }
  }

  /// Goes on to the next vertex of a line, defined or not.
  void go_to(std::uint32_t vertex) {
    if (before_) cross(*before_, vertex);
    if (before_ && oscillating_.contains(pair_of(*before_, vertex))) interrupt();
    if (tree_.geometry().is_defined(vertex)) {
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
  /// Goes to the next vertex by way of what is between.
  void cross(std::uint32_t from, std::uint32_t to) {
    const std::optional<EdgeFeature> feature = tree_.edges().feature(from, to);
    if (!feature) return;
    if (leaves_out(feature->kind)) return interrupt();
    append(feature->beside(from));
    if (feature->kind == FeatureKind::Jump) interrupt();
    append(feature->beside(to));
  }

  void append(std::uint32_t vertex) {
    const bool repeats = !chain_.empty() && point_[chain_.back()] == point_[vertex];
    if (!repeats) chain_.push_back(vertex);
  }
  void interrupt() {
    if (chain_.size() > 1) chains_.push_back(chain_);
    chain_.clear();
  }

  const Array<std::uint32_t>& point_;
  const CellTree& tree_;
  PairTable oscillating_;  ///< sides of leaves
  std::optional<std::uint32_t> before_;
  std::vector<std::uint32_t> chain_;
  std::vector<std::vector<std::uint32_t>> chains_;
};

/// Index of each of the even lines among the grid's, or of the nearest one, once each.
std::vector<std::size_t> indices(const std::vector<double>& lines, int count) {
  std::vector<std::size_t> result;
  if (count < 1) return result;
  const auto wanted =
      even_lines(lines.front(), lines.back(), static_cast<std::size_t>(std::max(count, 2) - 1));
  for (const double line : wanted) {
    const auto nearest = std::ranges::min_element(
        lines, {}, [line](double candidate) { return std::fabs(candidate - line); });
    const auto index = static_cast<std::size_t>(nearest - lines.begin());
    if (result.empty() || result.back() != index) result.push_back(index);
  }
  if (count == 1) result.resize(1);
  return result;
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
  const std::vector<View> views = singular_views(leaves, grid, tree);
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
      report.evaluations += static_cast<std::size_t>(limit.evaluations);
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

std::size_t LeafTriangles::expected() const {
  std::size_t sum = 0;
  for (const Range& range : ranges) sum += range.expected;
  return sum;
}

LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, std::span<const std::size_t> which,
                                 const SingularCorners& singular, const Grid& grid,
                                 const CellTree& tree) {
  LeafTriangles result;
  result.all.reserve(2 * which.size());
  result.ranges.reserve(which.size());
  const auto choose_corner = [&](std::size_t leaf, std::size_t sub_polygon, std::uint32_t& vertex) {
    if (!tree.geometry().is_regular(vertex)) vertex = singular.corner(leaf, sub_polygon, vertex);
  };
  PlainCutter cutter(grid);
  const auto add_plain = [&](std::size_t leaf, std::array<std::uint32_t, 4> corners) {
    const std::uint32_t cell = cell_cut_before(leaves[leaf], corners, grid, tree);
    if (cell != kNoCell) return cutter.add_cut(cell);
    for (std::uint32_t& vertex : corners) choose_corner(leaf, 0, vertex);
    cutter.add(corners);
  };
  for (const std::size_t leaf : which) {
    const auto plain = plain_corners(leaves[leaf], tree);
    result.ranges.push_back({.is_plain = plain.has_value()});
    if (plain) add_plain(leaf, *plain);
  }
  cutter.finish();
  std::vector<std::uint32_t> points;
  for (std::size_t k = 0; k < which.size(); ++k) {
    LeafTriangles::Range& range = result.ranges[k];
    range.first = static_cast<std::uint32_t>(result.all.size());
    std::size_t expected = 0;
    if (range.is_plain) {
      expected = cutter.take(result.all);
    } else {
      std::vector<Polygon> polygons = sub_polygons(leaves[which[k]], tree);
      for (std::size_t sub_polygon = 0; sub_polygon < polygons.size(); ++sub_polygon) {
        range.has_flat_sub_polygon = range.has_flat_sub_polygon || is_flat(polygons[sub_polygon]);
        points.clear();
        for (PolygonCorner& corner : polygons[sub_polygon]) {
          choose_corner(which[k], sub_polygon, corner.corner);
          points.push_back(grid.mesh.point[corner.corner]);
        }
        expected += triangles_between(points);
        triangulate_polygon(grid, std::move(polygons[sub_polygon]), result.all);
      }
    }
    range.count = static_cast<std::uint32_t>(result.all.size()) - range.first;
    range.expected = static_cast<std::uint32_t>(expected);
    range.is_plain = range.is_plain && range.count == 2;
  }
  return result;
}

std::vector<std::vector<std::uint32_t>> leaf_lines(const Grid& grid, const CellTree& tree,
                                                   std::span<const Leaf> leaves, int lines_u,
                                                   int lines_v) {
  Chains chains(grid, tree, leaves);
  const auto follow = [&](std::size_t cells, auto place_of) {
    const auto go_to = [&](std::uint32_t vertex, DyadicPoint) { chains.go_to(vertex); };
    for (std::size_t k = 0; k < cells; ++k)
      tree.vertices().walk(place_of(k), place_of(k + 1), go_to);
    chains.go_to(tree.vertices().used_vertex(place_of(cells)).value());
    chains.end_line();
  };
  const auto unit = [](std::size_t line) { return static_cast<std::uint32_t>(line) * kCellUnit; };
  for (const std::size_t i : indices(grid.u, lines_u)) {
    follow(grid.cells_v, [&](std::size_t k) { return DyadicPoint{unit(i), unit(k)}; });
  }
  for (const std::size_t j : indices(grid.v, lines_v)) {
    follow(grid.cells_u, [&](std::size_t k) { return DyadicPoint{unit(k), unit(j)}; });
  }
  return chains.take();
}

}  // namespace saddle
