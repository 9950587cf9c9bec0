#include "mesh/tree/cell_polygon.h"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>

#include "mesh/model/tolerances.h"
#include "mesh/tree/feature_count.h"
#include "mesh/tree/jump_lines.h"

namespace saddle {

namespace {

/// The cell polygon of a leaf, counter-clockwise in (u, v); vertices may be undefined.
Polygon cell_polygon(const Leaf& leaf, const CellTree& tree) {
  Polygon polygon;
  polygon.reserve(8);
  for (std::size_t k = 0; k < 4; ++k) {
    tree.vertices().walk(leaf, k, [&](std::uint32_t vertex, DyadicPoint place) {
      polygon.push_back({vertex, {place.u, place.v}});
    });
  }
  return polygon;
}

/// The points of the surface at the singular vertices of a polygon, each once.
std::vector<std::uint32_t> singular_points(const Polygon& polygon, const CellTree& tree) {
  std::vector<std::uint32_t> points;
  for (const PolygonCorner& corner : polygon) add_singular_vertex(corner.corner, tree, points);
  return points;
}

Bounds box_around(const Polygon& polygon) {
  Bounds box;
  for (const PolygonCorner& corner : polygon) box.add(dvec3(corner.place, 0));
  return box;
}

/// Whether a leaf is defined at two opposite corners only.
bool has_opposite_gaps(const Leaf& leaf, const CellTree& tree) {
  const auto& [a, b, c, d] = leaf.samples.corner;
  const auto is_defined = [&](std::uint32_t k) { return tree.geometry().is_defined(k); };
  return is_defined(a) == is_defined(c) && is_defined(b) == is_defined(d) &&
         is_defined(a) != is_defined(b);
}

/// A run of vertices between two features of the cell polygon.
struct Run {
  Polygon polygon;
  bool goes_far = false;  ///< to a pole or a point without limit
  bool is_thin = false;   ///< with a vertex in a thin part of a side

  void append(const Run& next) {
    polygon.insert(polygon.end(), next.polygon.begin(), next.polygon.end());
    goes_far = goes_far || next.goes_far;
    is_thin = is_thin || next.is_thin;
  }
};

/// Cuts a cell polygon at its features.
class Cutter {
 public:
  Cutter(const Leaf& leaf, const Polygon& whole, const CellTree& tree)
      : leaf_(leaf), whole_(whole), tree_(tree) {
    for (std::size_t k = 0; k < whole.size(); ++k) go_on(k);
  }

  /// The sheets between lines of jumps that go through the leaf side by side.
  std::vector<Polygon> take(const JumpLines& lines) const {
    const std::vector<JumpCrossing>& crossings = lines.crossings();
    std::vector<Polygon> result;
    std::vector<bool> is_done(crossings.size(), false);
    for (std::size_t first = 0; first < crossings.size(); ++first) {
      Polygon sheet;
      // Around the leaf to the next jump, and along that to its other end.
      for (std::size_t k = first; !is_done[k]; k = lines.partner((k + 1) % crossings.size())) {
        is_done[k] = true;
        const JumpCrossing& next = crossings[(k + 1) % crossings.size()];
        sheet.push_back(corner(crossings[k].after));
        const std::size_t end = next.corner + (k + 1 < crossings.size() ? 0 : whole_.size());
        for (std::size_t i = crossings[k].corner + 1; i <= end; ++i)
          sheet.push_back(whole_[i % whole_.size()]);
        sheet.push_back(corner(next.before));
      }
      if (!sheet.empty()) add(std::move(sheet), result);
    }
    return result;
  }

  /// `folded`: a crease goes through the leaf, between features or singular points. `has_middle`:
  /// the surface is defined in the leaf's middle. `has_opposite_gaps`: of the leaf.
  std::vector<Polygon> take(bool folded, bool has_middle, bool has_opposite_gaps) {
    // A crease that ends in the leaf leaves it whole. A jump or a pole would make a wall.
    if (cuts_ == 1 && creases_.empty()) return {};
    if (cuts_ > boundaries_ && faces_ % 2 == 1) return {};  // so would a pole that leaves unnoticed
    if (cuts_ == boundaries_ + 1 && creases_.size() == 1) join_at_crease_in_strip();
    if (cuts_ > 0) join_ends();
    const bool may_cross = has_opposite_gaps && (faces_ > 0 || !is_thin_strip());
    const bool is_parted = lines_ > 1 || thin_gaps_ > 0 || may_cross;
    if (cuts_ == boundaries_ && !is_parted && (has_middle || is_thin_strip())) join_runs();
    if (folded && cuts_ < 2) cut_at_singular_points();
    std::vector<Polygon> result;
    if (cuts_ == 1 && cliffs_.size() == 1 && runs_.size() == 1) {
      Polygon& whole = runs_.front().polygon;
      whole.insert(whole.end(), creases_.begin(), creases_.end());
      creases_.clear();
    }
    join_first_cliff();
    if (cliffs_.size() == 2 && cliffs_[0] + cliffs_[1] == creases_.size()) {
      const auto crossings = std::span(creases_);
      for (Polygon& strip : strips_between(crossings.first(cliffs_[0]), crossings.last(cliffs_[1])))
        add(std::move(strip), result);
    } else if (creases_.size() >= 3) {
      add(middle(), result);
    }
    for (Run& run : runs_) {
      if (!run.goes_far) add(std::move(run.polygon), result);
    }
    return result;
  }

 private:
  /// The polygon between creases that cross more than two sides. It takes the hanging vertices of
  /// flat runs, which are no polygons by themselves.
  Polygon middle() {
    if (creases_.size() != runs_.size()) return std::move(creases_);
    Polygon polygon;
    for (std::size_t k = 0; k < creases_.size(); ++k) {
      polygon.push_back(creases_[k]);
      Polygon& run = runs_[(k + 1) % runs_.size()].polygon;
      if (!is_flat(run)) continue;
      for (std::size_t i = 1; i + 1 < run.size(); ++i) polygon.push_back(run[i]);
      run.clear();
    }
    return polygon;
  }

  /// Joins the first crossing of a cliff with the last, if they are one around a corner.
  void join_first_cliff() {
    if (cliffs_.size() < 3 || creases_.front().place != creases_.back().place) return;
    std::rotate(creases_.begin(), creases_.end() - static_cast<std::ptrdiff_t>(cliffs_.back()),
                creases_.end());
    cliffs_.front() += cliffs_.back();
    cliffs_.pop_back();
  }

  PolygonCorner corner(std::uint32_t vertex) const {
    return {vertex, tree_.vertices().place_between(vertex)};
  }
  void append(std::uint32_t vertex) { runs_.back().polygon.push_back(corner(vertex)); }

  void cut() {
    ++cuts_;
    runs_.emplace_back();
  }

  /// Appends vertex k, and the feature between it and the next.
  void go_on(std::size_t k) {
    append_vertex(whole_[k]);
    const std::uint32_t a = whole_[k].corner;
    const std::uint32_t b = whole_[(k + 1) % whole_.size()].corner;
    const auto feature = tree_.edges().feature(a, b);
    if (!feature) return;
    append_beside(*feature, a);
    count(*feature, a);
    cut();
    append_beside(*feature, b);
  }

  void append_vertex(const PolygonCorner& at) {
    const std::uint32_t vertex = at.corner;
    if (tree_.geometry().is_defined(vertex)) {
      runs_.back().polygon.push_back(at);
      if (tree_.thin().contains(vertex)) runs_.back().is_thin = true;
    } else {
      cut();
      ++boundaries_;
      if (tree_.thin().contains(vertex)) ++thin_gaps_;
      if (tree_.geometry().singularity(vertex) == PointSingularity::Kind::Line) ++lines_;
    }
  }

  /// Appends a feature's own vertex on the side of one of its ends.
  void append_beside(const EdgeFeature& feature, std::uint32_t end) {
    if (!tree_.geometry().is_defined(end)) return;
    const bool far = leaves_out(feature.kind);
    runs_.back().goes_far = runs_.back().goes_far || far;
    if (!far) append(feature.beside(end));
  }

  /// `from`: the end of the feature's side that comes first.
  void count(const EdgeFeature& feature, std::uint32_t from) {
    if (feature.is_boundary()) ++boundaries_;
    if (feature.kind == FeatureKind::Face && tree_.geometry().is_defined(from)) ++faces_;
    if (feature.kind == FeatureKind::Crease)
      creases_.push_back(
          {feature.beside(from), tree_.vertices().place_between(feature.beside_first)});
    if (feature.kind == FeatureKind::Cliff) append_cliff(feature, from);
  }

  void append_cliff(const EdgeFeature& feature, std::uint32_t from) {
    // One crossing may go through a corner of the leaf.
    const PolygonCorner first = corner(feature.on_strip(0, from)[0]);
    if (cliffs_.empty() || creases_.back().place != first.place) cliffs_.push_back(0);
    cliffs_.back() += std::size_t{2} * feature.strips;
    for (std::size_t k = 0; k < feature.strips; ++k) {
      for (const std::uint32_t vertex : feature.on_strip(k, from))
        creases_.push_back(corner(vertex));
    }
  }

  /// Takes back the cut at the only crease, if there is a thin strip, whose creases are not known.
  void join_at_crease_in_strip() {
    if (std::ranges::none_of(runs_, &Run::is_thin)) return;
    const auto begins = [&](const Run& run) {
      return !run.polygon.empty() && run.polygon.front().place == creases_.front().place;
    };
    const auto next = std::ranges::find_if(runs_, begins);
    if (next == runs_.begin() || next == runs_.end()) return;
    std::prev(next)->append(*next);
    runs_.erase(next);
    creases_.clear();
    --cuts_;
  }

  /// The cell polygon is closed: its first run continues its last.
  void join_ends() {
    Run last = std::move(runs_.back());
    runs_.pop_back();
    last.append(runs_.front());
    runs_.front() = std::move(last);
  }

  /// Whether the leaf is defined on a strip alone, which is thin where it enters.
  bool is_thin_strip() const {
    const auto is_there = [](const Run& run) { return !run.polygon.empty(); };
    return std::ranges::count_if(runs_, is_there) == 2 && std::ranges::any_of(runs_, &Run::is_thin);
  }

  /// Joins the runs between boundaries that only cut corners off. The caller excludes undefined
  /// lines, and boundaries that may cross in the leaf, as at infinity or on a chessboard.
  void join_runs() {
    Polygon& whole = runs_.front().polygon;
    for (std::size_t k = 1; k < runs_.size(); ++k) {
      whole.insert(whole.end(), runs_[k].polygon.begin(), runs_[k].polygon.end());
    }
    runs_.resize(1);
  }

  /// Cuts along a crease that ends in a singular point, or goes from one to another.
  void cut_at_singular_points() {
    Polygon& whole = runs_.front().polygon;
    const std::vector<std::uint32_t> points = singular_points(whole, tree_);
    if (cuts_ + points.size() != 2) return;
    const auto& point = tree_.mesh().point;
    if (cuts_ == 1 && point[creases_.front().corner] == points.back()) return;  // it only ends here
    if (cuts_ == 0) start_after(points[0], whole);
    const auto is_there = [&](const PolygonCorner& c) { return point[c.corner] == points.back(); };
    const auto first = std::ranges::find_if(whole, is_there);
    const auto last = std::find_if(whole.rbegin(), whole.rend(), is_there).base() - 1;
    Run rest{{last, whole.end()}};
    whole.erase(first + 1, whole.end());
    runs_.push_back(std::move(rest));
  }

  /// Rotates a polygon so that it begins and ends at a point.
  void start_after(std::uint32_t point, Polygon& polygon) const {
    const auto is_there = [&](const PolygonCorner& c) {
      return tree_.mesh().point[c.corner] == point;
    };
    const auto elsewhere = std::ranges::find_if_not(polygon, is_there);
    // The point is then inside or at the end.
    std::rotate(polygon.begin(), elsewhere, polygon.end());
    const auto end = std::find_if(polygon.rbegin(), polygon.rend(), is_there).base();
    std::rotate(polygon.begin(), end, polygon.end());
    polygon.insert(polygon.begin(), polygon.back());
  }

  /// Adds a polygon without repeated corners: a feature may be at a vertex. Between boundaries
  /// alone, a polygon that is only a side of the leaf is dropped; between creases it holds sheets
  /// together.
  void add(Polygon polygon, std::vector<Polygon>& result) const {
    const auto same = [](const PolygonCorner& a, const PolygonCorner& b) {
      return a.corner == b.corner || a.place == b.place;
    };
    polygon.erase(std::unique(polygon.begin(), polygon.end(), same), polygon.end());
    while (polygon.size() > 1 && same(polygon.front(), polygon.back())) polygon.pop_back();
    const bool has_inner = add_inner_vertices(polygon);
    if (has_inner)
      cut_off_pinched(kSame * std::max(leaf_.size_u(), leaf_.size_v()), polygon, result);
    const bool is_side = cuts_ > 0 && cuts_ == boundaries_ && is_flat(polygon);
    const bool is_empty = has_inner && !has_area(polygon);
    if (polygon.size() >= 3 && !is_side && !is_empty) result.push_back(std::move(polygon));
  }

  /// Returns whether there are any.
  bool add_inner_vertices(Polygon& polygon) const {
    bool has_inner = false;
    if (!tree_.inner().has(leaf_)) return false;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const PolygonCorner& next = polygon[(k + 1) % polygon.size()];
      const dvec2 low(leaf_.low.u, leaf_.low.v);
      const dvec2 middle = 0.5 * (polygon[k].place + next.place) - low;
      const dvec2 size(leaf_.size_u(), leaf_.size_v());
      if (!is_chord(middle / size, {polygon[k].corner, next.corner}, tree_)) continue;
      const auto inner = tree_.inner().between(leaf_, {polygon[k], next});
      if (!inner) continue;
      has_inner = true;
      const PolygonCorner corner = {*inner, tree_.vertices().place_between(*inner)};
      polygon.insert(polygon.begin() + static_cast<std::ptrdiff_t>(++k), corner);
    }
    return has_inner;
  }

  const Leaf& leaf_;
  const Polygon& whole_;
  const CellTree& tree_;
  std::vector<Run> runs_{1};
  Polygon creases_;                  // where creases and the segments of cliffs cross sides
  std::vector<std::size_t> cliffs_;  // corners of each crossing of a cliff
  std::size_t cuts_ = 0;
  std::size_t boundaries_ = 0;  // among the cuts
  std::size_t lines_ = 0;       // vertices on undefined lines
  std::size_t thin_gaps_ = 0;   // undefined vertices in thin parts of sides
  std::size_t faces_ = 0;       // times that the surface leaves the clip box
};

}  // namespace

std::vector<Polygon> sub_polygons(const Leaf& leaf, const CellTree& tree) {
  if (leaf.state.is_left_out()) return {};
  Polygon whole = cell_polygon(leaf, tree);
  if (!tree.edges().may_be_crossed(leaf) && leaf.state.is_whole()) {
    std::vector<Polygon> result;
    result.push_back(std::move(whole));
    return result;
  }
  Cutter cutter(leaf, whole, tree);
  const JumpLines lines(leaf, tree);
  if (lines.count() > 0) return cutter.take(lines);
  return cutter.take(leaf.state.is_cut_by_feature(), tree.is_centre_defined(leaf),
                     has_opposite_gaps(leaf, tree));
}

std::uint32_t count_polygon_vertices(const Leaf& leaf, const CellTree& tree) {
  std::uint32_t count = 0;
  for_sides(leaf, tree, [&](std::uint32_t, std::uint32_t) { ++count; });
  return count;
}

std::array<dvec3, 4> corner_positions(const Leaf& leaf, const CellTree& tree) {
  const auto& [a, b, c, d] = leaf.samples.corner;
  const auto& position = tree.mesh().position;
  return {position[a], position[b], position[c], position[d]};
}

std::vector<Side> sides_of(const Leaf& leaf, const CellTree& tree) {
  std::vector<Side> sides;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) { sides.push_back(side_of(a, b)); });
  return sides;
}

std::optional<std::array<std::uint32_t, 4>> plain_corners(const Leaf& leaf, const CellTree& tree) {
  if (!leaf.state.is_whole() || leaf.state.is_left_out()) return std::nullopt;
  const auto& corners = leaf.samples.corner;
  for (std::size_t k = 0; k < 4; ++k) {
    if (tree.vertices().is_halved(leaf, k) || !tree.geometry().is_defined(corners[k]))
      return std::nullopt;
  }
  if (!tree.edges().may_be_crossed(leaf)) return corners;
  for (std::size_t k = 0; k < 4; ++k) {
    if (tree.edges().feature(corners[k], corners[(k + 1) % 4])) return std::nullopt;
  }
  return corners;
}

bool is_chord(const dvec2& middle, const Side& edge, const CellTree& tree) {
  const bool is_inside =
      std::min(middle.x, middle.y) > kSame && std::max(middle.x, middle.y) < 1 - kSame;
  return is_inside ||
         (tree.vertices().is_on_feature(edge[0]) && tree.vertices().is_on_feature(edge[1]));
}

bool is_flat(const Polygon& sub_polygon) {
  const Bounds box = box_around(sub_polygon);
  return box.empty() || std::min(box.size().x, box.size().y) <= rounding_of_place(box.high);
}

std::optional<bool> flat_sub_polygon_along_u(const Leaf& leaf, const CellTree& tree) {
  for (const Polygon& sub_polygon : sub_polygons(leaf, tree)) {
    if (!is_flat(sub_polygon)) continue;
    const dvec3 size = box_around(sub_polygon).size();
    return size.x > size.y;
  }
  return std::nullopt;
}

}  // namespace saddle
