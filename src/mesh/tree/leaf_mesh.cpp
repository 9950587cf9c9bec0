#include "mesh/tree/leaf_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/numbers.h"
#include "base/parallel.h"
#include "mesh/grid/cell_loops.h"
#include "mesh/grid/triangulate.h"
#include "mesh/grid/vertex_columns.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/polygon.h"
#include "mesh/tree/singular_corners.h"

namespace saddle {

namespace {

/// The root cell that a plain leaf is, if the grid has triangulated it. Otherwise kNoIndex.
std::uint32_t cell_cut_before(const Leaf& leaf, const std::array<std::uint32_t, 4>& corners,
                              const Grid& grid, const CellTree& tree) {
  if (leaf.size_u() != kCellUnit || leaf.size_v() != kCellUnit) return kNoIndex;
  const std::size_t cell = grid.cell(leaf.low.u / kCellUnit, leaf.low.v / kCellUnit);
  const bool is_cut =
      grid.cells[cell] == GridCell::Two && std::ranges::all_of(corners, [&](std::uint32_t corner) {
        return tree.geometry().is_regular(corner);
      });
  return is_cut ? static_cast<std::uint32_t>(cell) : kNoIndex;
}

/// Triangulates plain leaves by the loop of grid cells, a block at a time.
class PlainCutter {
 public:
  explicit PlainCutter(const Grid& grid) : grid_(grid) {}

  void add(const std::array<std::uint32_t, 4>& corners) {
    cells_.push_back(kNoIndex);
    corners_.push_back(corners);
    // A leaf takes two vertices of each strip; the cells between leaves are not used.
    if (corners_.size() % (kTileCells / 2) == 0) cut();
  }
  /// Adds a leaf that is a root cell with triangles.
  void add_cut(std::uint32_t cell) { cells_.push_back(cell); }
  void finish() {
    if (cuts_.size() < corners_.size()) cut();
  }

  /// Appends the triangles of the next leaf. Returns their count if all had an area.
  std::size_t take(Array<Triangle>& triangles) {
    const std::uint32_t cell = cells_[taken_++];
    if (cell != kNoIndex) {
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
  std::vector<std::uint32_t> cells_;  // of all leaves; kNoIndex stands for the next of corners_
  std::vector<std::array<std::uint32_t, 4>> corners_;
  std::vector<Way> cuts_;
  std::size_t taken_ = 0;
  std::size_t taken_corners_ = 0;
  std::unique_ptr<Strips> strips_ = std::make_unique_for_overwrite<Strips>();
  std::unique_ptr<Cuts> found_ = std::make_unique_for_overwrite<Cuts>();
};

/// Puts the corner that a leaf's sub-polygon takes in place of a singular vertex.
struct CornerChoice {
  const SingularCorners& singular;
  const CellTree& tree;

  void operator()(std::size_t leaf, std::size_t sub_polygon, std::uint32_t& vertex) const {
    if (!tree.geometry().is_regular(vertex)) vertex = singular.corner(leaf, sub_polygon, vertex);
  }
};

/// Adds the triangles of a leaf's sub-polygons. Returns the number that their corners suggest.
std::size_t add_polygons(const Leaf& leaf, std::size_t number, const CornerChoice& choose_corner,
                         const Grid& grid, LeafTriangles::Range& range,
                         Array<Triangle>& triangles) {
  std::size_t expected = 0;
  std::vector<std::uint32_t> points;
  std::vector<Polygon> polygons = sub_polygons(leaf, choose_corner.tree);
  for (std::size_t sub_polygon = 0; sub_polygon < polygons.size(); ++sub_polygon) {
    const bool has_no_area = is_flat(polygons[sub_polygon]);
    range.has_flat_sub_polygon = range.has_flat_sub_polygon || has_no_area;
    points.clear();
    for (PolygonCorner& corner : polygons[sub_polygon]) {
      choose_corner(number, sub_polygon, corner.corner);
      points.push_back(grid.mesh.point[corner.corner]);
    }
    // Creases hold flat triangles between sheets. Beside a jump they would fill what is between
    // the leaf's side and the edges of its neighbour.
    if (has_no_area && has_cut(FeatureKind::Jump, leaf, choose_corner.tree)) continue;
    if (!has_no_area) expected += triangles_between(points);
    triangulate_polygon(grid, std::move(polygons[sub_polygon]), triangles);
  }
  return expected;
}

LeafTriangles triangulate(std::span<const Leaf> leaves, std::span<const std::size_t> which,
                          const SingularCorners& singular, const Grid& grid, const CellTree& tree) {
  LeafTriangles result;
  result.all.reserve(2 * which.size());
  result.ranges.reserve(which.size());
  const CornerChoice choose_corner{singular, tree};
  PlainCutter cutter(grid);
  const auto add_plain = [&](std::size_t leaf, std::array<std::uint32_t, 4> corners) {
    const std::uint32_t cell = cell_cut_before(leaves[leaf], corners, grid, tree);
    if (cell != kNoIndex) return cutter.add_cut(cell);
    for (std::uint32_t& vertex : corners) choose_corner(leaf, 0, vertex);
    cutter.add(corners);
  };
  for (const std::size_t leaf : which) {
    const auto plain = plain_corners(leaves[leaf], tree);
    result.ranges.push_back({.is_plain = plain.has_value()});
    if (plain) add_plain(leaf, *plain);
  }
  cutter.finish();
  for (std::size_t k = 0; k < which.size(); ++k) {
    LeafTriangles::Range& range = result.ranges[k];
    range.first = static_cast<std::uint32_t>(result.all.size());
    const std::size_t expected =
        range.is_plain
            ? cutter.take(result.all)
            : add_polygons(leaves[which[k]], which[k], choose_corner, grid, range, result.all);
    range.count = static_cast<std::uint32_t>(result.all.size()) - range.first;
    range.expected = static_cast<std::uint32_t>(expected);
    range.is_plain = range.is_plain && range.count == 2;
  }
  return result;
}

}  // namespace

std::size_t LeafTriangles::expected() const {
  std::size_t sum = 0;
  for (const Range& range : ranges) sum += range.expected;
  return sum;
}

void LeafTriangles::append(const LeafTriangles& others) {
  const auto first = static_cast<std::uint32_t>(all.size());
  all.insert(all.end(), others.all.begin(), others.all.end());
  for (Range range : others.ranges) {
    range.first += first;
    ranges.push_back(range);
  }
}

void LeafTriangles::remove(std::size_t leaf, const Triangle& triangle) {
  Range& range = ranges[leaf];
  const auto own = std::span(all).subspan(range.first, range.count);
  const auto removed = std::ranges::find(own, triangle);
  std::rotate(removed, removed + 1, own.end());
  --range.count;
  range.is_plain = false;
}

LeafTriangles triangulate_leaves(std::span<const Leaf> leaves, std::span<const std::size_t> which,
                                 const SingularCorners& singular, const Grid& grid,
                                 const CellTree& tree, unsigned threads) {
  if (which.size() <= kInBatch) return triangulate(leaves, which, singular, grid, tree);
  std::vector<LeafTriangles> parts =
      results_of_chunks(which.size(), kInBatch, threads, [&](std::size_t begin, std::size_t end) {
        return triangulate(leaves, which.subspan(begin, end - begin), singular, grid, tree);
      });
  LeafTriangles result;
  result.all.reserve(2 * which.size());
  result.ranges.reserve(which.size());
  for (LeafTriangles& part : parts) result.append(std::exchange(part, {}));
  return result;
}

}  // namespace saddle
