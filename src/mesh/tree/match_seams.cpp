#include "mesh/tree/match_seams.h"
#include "mesh/tree/cell_polygon.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace saddle {

namespace {

/// The place across a seam or fold that is one point with `place`; nothing off the seams.
std::optional<DyadicPoint> partner(const Seams& seams, const Grid& grid, DyadicPoint place) {
  const auto end_u = static_cast<std::uint32_t>(grid.cells_u) * kCellUnit;
  const auto end_v = static_cast<std::uint32_t>(grid.cells_v) * kCellUnit;
  if (seams.u.closed && place.u == 0) {
    return DyadicPoint{end_u, seams.u.partner(place.v, end_v)};
  }
  if (seams.u.closed && place.u == end_u) {
    return DyadicPoint{0, seams.u.partner_back(place.v, end_v)};
  }
  if (seams.v.closed && place.v == 0) {
    return DyadicPoint{seams.v.partner(place.u, end_u), end_v};
  }
  if (seams.v.closed && place.v == end_v) {
    return DyadicPoint{seams.v.partner_back(place.u, end_u), 0};
  }
  if ((seams.folded_u[0] && place.u == 0) || (seams.folded_u[1] && place.u == end_u)) {
    return DyadicPoint{place.u, kFold.partner(place.v, end_v)};
  }
  if ((seams.folded_v[0] && place.v == 0) || (seams.folded_v[1] && place.v == end_v)) {
    return DyadicPoint{kFold.partner(place.u, end_u), place.v};
  }
  return std::nullopt;
}

/// Takes the middles of folded edges into use, where these turn back.
void use_middles_of_folds(const Seams& seams, const Grid& grid, CellTree& tree) {
  const auto end_u = static_cast<std::uint32_t>(grid.cells_u) * kCellUnit;
  const auto end_v = static_cast<std::uint32_t>(grid.cells_v) * kCellUnit;
  for (std::uint32_t k = 0; k < 2; ++k) {
    if (seams.folded_u[k]) tree.vertices().use(tree.vertices().vertex({k * end_u, end_v / 2}));
    if (seams.folded_v[k]) tree.vertices().use(tree.vertices().vertex({end_u / 2, k * end_v}));
  }
}

/// Calls f(a, b) for neighbours a and b on the sides of a leaf. The leaf beyond a halved side has
/// its hanging vertices as corners; at the border of the domain there is none.
template <class F>
void for_own_sides(const Leaf& leaf, const Grid& grid, const CellTree& tree, F f) {
  const DyadicPoint end = {static_cast<std::uint32_t>(grid.cells_u) * kCellUnit,
                           static_cast<std::uint32_t>(grid.cells_v) * kCellUnit};
  const bool is_at_border =
      leaf.low.u == 0 || leaf.low.v == 0 || leaf.high().u == end.u || leaf.high().v == end.v;
  if (is_at_border) return for_sides(leaf, tree, f);
  const auto& corners = leaf.samples.corner;
  for (std::size_t k = 0; k < 4; ++k) f(corners[k], corners[(k + 1) % 4]);
}

/// The longer of the two sides of a leaf that run along the side from a to b, in local units.
double length_across(const Leaf& leaf, std::uint32_t a, std::uint32_t b, const Grid& grid,
                     const CellTree& tree) {
  const auto& c = leaf.samples.corner;
  const bool along_u = tree.vertices().place(a).v == tree.vertices().place(b).v;
  const auto length = [&](std::size_t from, std::size_t to) {
    const double length = glm::distance(grid.local(c[from]), grid.local(c[to]));
    return std::isfinite(length) ? length : 0;
  };
  return along_u ? std::max(length(0, 1), length(3, 2)) : std::max(length(0, 3), length(1, 2));
}

/// Calls f(a, b) for neighbours a and b around the sub-polygons of a leaf.
template <class F>
void for_sides_of_sub_polygons(const Leaf& leaf, const CellTree& tree, F f) {
  for (const Polygon& sub_polygon : sub_polygons(leaf, tree)) {
    for (std::size_t k = 0; k < sub_polygon.size(); ++k) {
      f(sub_polygon[k].corner, sub_polygon[(k + 1) % sub_polygon.size()].corner);
    }
  }
}

/// Points to which sides of leaves collapse, and the range of their places.
class Poles {
 public:
  Poles(const Grid& grid, const CellTree& tree) : grid_(grid), tree_(tree) {}

  /// Adds a side of a leaf or of a sub-polygon, if it is a point.
  void add(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t point = grid_.mesh.point[a];
    if (point != grid_.mesh.point[b]) return;
    const dvec2 place = tree_.vertices().place_between(a);
    const auto [found, is_new] = ways_.try_emplace(point, Ways{place, place});
    Ways& ways = found->second;
    for (const dvec2& other : {place, tree_.vertices().place_between(b)}) {
      ways.low = glm::min(ways.low, other);
      ways.high = glm::max(ways.high, other);
    }
  }

  /// Makes poles at the same position one point.
  void join(PointUnion& points) {
    std::vector<std::uint32_t> distinct;
    for (const auto& [point, ways] : ways_) {
      const auto is_same = [&, pole = point](std::uint32_t other) {
        return is_one_point(grid_, pole, other);
      };
      const auto found = std::ranges::find_if(distinct, is_same);
      if (found == distinct.end()) {
        distinct.push_back(point);
      } else {
        points.unite(point, *found);
      }
    }
    meet_ = meet_ || distinct.size() < ways_.size();
  }

  /// Whether poles were joined, or one extends along both u and v.
  bool meet() const {
    return meet_ || std::ranges::any_of(ways_, [](const auto& pole) {
             const dvec2 size = pole.second.high - pole.second.low;
             return size.x > 0 && size.y > 0;
           });
  }

 private:
  struct Ways {
    dvec2 low, high;
  };

  const Grid& grid_;
  const CellTree& tree_;
  std::map<std::uint32_t, Ways> ways_;
  bool meet_ = false;
};

}  // namespace

std::vector<SeamSide> seam_sides_with_features(const Seams& seams, const Grid& grid,
                                               const CellTree& tree) {
  std::vector<SeamSide> result;
  for (const Side& side : tree.edges().sides_with_features()) {
    const DyadicPoint a = tree.vertices().place(side[0]);
    const DyadicPoint b = tree.vertices().place(side[1]);
    if (a.u != b.u && a.v != b.v) continue;
    const auto place_c = partner(seams, grid, a);
    const auto place_d = place_c ? partner(seams, grid, b) : std::nullopt;
    if (!place_d) continue;
    const auto vertex_c = tree.vertices().used_vertex(*place_c);
    const auto vertex_d = tree.vertices().used_vertex(*place_d);
    if (!vertex_c || !vertex_d) continue;
    // Both ends are on a seam. The side is on it if the partners are as far apart.
    const bool along_u = a.v == b.v;
    const auto length = [&](const DyadicPoint& p, const DyadicPoint& q) {
      const auto [low, high] = along_u ? std::minmax(p.u, q.u) : std::minmax(p.v, q.v);
      return high - low;
    };
    if (length(a, b) == length(*place_c, *place_d))
      result.push_back({side, {*vertex_c, *vertex_d}});
  }
  return result;
}

void mirror_seams(const Seams& seams, unsigned threads, const Grid& grid, CellTree& tree,
                  PointUnion& points) {
  use_middles_of_folds(seams, grid, tree);
  // Corners of the domain may have two partners. They are vertices of the root grid, welded before.
  std::vector<Side> pairs;
  for (const std::uint32_t vertex : tree.vertices().take_newly_used()) {
    const std::optional<DyadicPoint> other = partner(seams, grid, tree.vertices().place(vertex));
    if (!other) continue;
    const std::uint32_t twin = tree.vertices().vertex(*other);
    tree.vertices().use(twin);
    pairs.push_back({vertex, twin});
  }
  tree.geometry().evaluate(threads);
  // Where a jump meets a seam, rounding may leave partners on different sheets.
  const auto are_apart = [&](std::uint32_t a, std::uint32_t b) {
    return tree.geometry().is_defined(a) && tree.geometry().is_defined(b) &&
           !is_one_point(tree.surface(), grid, a, b);
  };
  for (const auto& [a, b] : pairs) {
    if (!are_apart(a, b)) points.unite(a, b);
  }
}

void join_features(const Seams& seams, const Grid& grid, const CellTree& tree, PointUnion& points) {
  for (const SeamSide& both : seam_sides_with_features(seams, grid, tree)) {
    const auto feature = tree.edges().feature(both.side[0], both.side[1]);
    const auto other = tree.edges().feature(both.other[0], both.other[1]);
    if (!other || other->kind != feature->kind || leaves_out(other->kind)) continue;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t a = feature->beside(both.side[k]);
      const std::uint32_t b = other->beside(both.other[k]);
      if (is_one_point(grid, a, b)) points.unite(a, b);
    }
  }
}

bool join_poles(std::span<const Leaf> leaves, unsigned threads, const Grid& grid, CellTree& tree,
                PointUnion& points) {
  std::vector<Neighbours> joined;
  std::vector<Neighbours> sides;
  std::vector<Neighbours> cuts;
  const auto file = [&](std::uint32_t a, std::uint32_t b, double beside,
                        std::vector<Neighbours>& as) {
    if (grid.mesh.point[a] == grid.mesh.point[b]) {
      joined.push_back({a, b});
    } else if (tree.geometry().is_defined(a) && tree.geometry().is_defined(b) &&
               is_one_point(grid, a, b) && is_short_beside(grid, a, b, beside)) {
      as.push_back({a, b});
    }
  };
  for (const Leaf& leaf : leaves) {
    for_own_sides(leaf, grid, tree, [&](auto a, auto b) {
      file(a, b, length_across(leaf, a, b, grid, tree), sides);
    });
    if (!leaf.state.is_cut_by_feature()) continue;
    for_sides_of_sub_polygons(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
      file(a, b, std::numeric_limits<double>::infinity(), cuts);
    });
  }
  for (const auto& [a, b] : collapsed(tree.surface(), grid, sides, threads)) {
    points.unite(a, b);
    tree.geometry().make_singular(a);
    tree.geometry().make_singular(b);
  }
  for (const auto& [a, b] : cuts) points.unite(a, b);
  points.settle();
  if (!tree.geometry().has_singular()) return false;
  Poles poles(grid, tree);
  for (const auto& which : {joined, sides, cuts}) {
    for (const auto& [a, b] : which) poles.add(a, b);
  }
  poles.join(points);
  return poles.meet();
}

}  // namespace saddle
