#include "mesh/tree/feature_count.h"

#include <algorithm>
#include <array>
#include <optional>

#include <glm/geometric.hpp>

#include "base/vec.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/jump_lines.h"

namespace saddle {

void add_singular_vertex(std::uint32_t vertex, const CellTree& tree,
                         std::vector<std::uint32_t>& points) {
  if (tree.geometry().is_regular(vertex)) return;
  const std::uint32_t point = tree.mesh().point[vertex];
  if (std::ranges::count(points, point) == 0) points.push_back(point);
}

bool is_wide_strip(const EdgeFeature& feature, std::size_t strip, const Side& side,
                   const CellTree& tree) {
  const auto& uv = tree.mesh().uv;
  const auto [first, second] = feature.on_strip(strip, side[0]);
  return glm::distance(uv[first], uv[second]) > kClose * glm::distance(uv[side[0]], uv[side[1]]);
}

bool has_cut(FeatureKind kind, const Leaf& leaf, const CellTree& tree) {
  bool has_cut = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const EdgeCut* const side = has_cut ? nullptr : tree.edges().find_cut(a, b);
    has_cut = has_cut || (side != nullptr && side->feature && side->feature->kind == kind);
  });
  return has_cut;
}

bool has_thin_vertex(const Leaf& leaf, const CellTree& tree) {
  bool has = false;
  if (!tree.thin().any()) return false;
  for_sides(leaf, tree,
            [&](std::uint32_t a, std::uint32_t) { has = has || tree.thin().contains(a); });
  return has;
}

bool has_thin_strip(const Leaf& leaf, const CellTree& tree) {
  bool has = false;
  if (!tree.thin().any()) return false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t) {
    has = has || (tree.thin().contains(a) && tree.geometry().is_defined(a));
  });
  return has;
}

bool is_cusp(std::uint32_t a, std::uint32_t b, const CellTree& tree) {
  const auto& point = tree.mesh().point;
  return tree.geometry().is_defined(a) && tree.geometry().is_defined(b) &&
         !tree.geometry().is_regular(a) && !tree.geometry().is_regular(b) && point[a] != point[b];
}

bool is_cut_along_u(const Leaf& leaf, const CellTree& tree) {
  Bounds cuts;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const std::optional<EdgeFeature> feature = tree.edges().feature(a, b);
    if (feature) cuts.add(dvec3(tree.vertices().place_between(feature->beside_first), 0));
    if (!is_cusp(a, b, tree)) return;
    for (const std::uint32_t end : {a, b}) cuts.add(dvec3(tree.vertices().place_between(end), 0));
  });
  const dvec3 size = cuts.empty() ? dvec3(0) : cuts.size();
  const double along_u = size.x / leaf.size_u();
  const double along_v = size.y / leaf.size_v();
  return along_u == 0 && along_v == 0 ? leaf.size_u() >= leaf.size_v() : along_u >= along_v;
}

namespace {

/// Whether a jump cuts a side at the place of its end `vertex`, or that is on a cliff. A crease
/// does not count: there the vertex belongs to both sheets.
bool is_cut_at(std::uint32_t vertex, std::uint32_t other, const CellTree& tree) {
  const std::optional<EdgeFeature> feature = tree.edges().feature(vertex, other);
  if (feature && feature->kind == FeatureKind::Cliff) return feature->beside(vertex) == vertex;
  return feature && feature->kind == FeatureKind::Jump &&
         tree.vertices().place_between(feature->beside(other)) ==
             tree.vertices().place_between(vertex);
}

bool is_at_corner(const EdgeFeature& feature, const Leaf& leaf, const CellTree& tree) {
  const dvec2 place = tree.vertices().place_between(feature.beside_first);
  return std::ranges::any_of(leaf.corners(), [&](const DyadicPoint& corner) {
    return place == dvec2(corner.u, corner.v);
  });
}

/// The number of vertices at which jumps cut both sides.
std::size_t count_cut_vertices(const Leaf& leaf, const CellTree& tree) {
  std::size_t count = 0;
  std::optional<bool> leaves_first;  // whether the first side is cut where it begins
  bool arrives = false;              // whether the side before is where it ends
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const bool leaves = is_cut_at(a, b, tree);
    if (!leaves_first) leaves_first = leaves;
    if (arrives && leaves) ++count;
    arrives = is_cut_at(b, a, tree);
  });
  if (arrives && leaves_first.value_or(false)) ++count;
  return count;
}

/// The faces of the clip box through which the surface leaves it along the sides of a leaf.
class FacesAround {
 public:
  /// A side that is cut: the faces beyond which its two ends are.
  void add(int from, int to) {
    changes_ = changes_ || (last_ && *last_ != from);
    if (!first_) first_ = from;
    last_ = to;
    ++sides_;
  }
  /// Whether a cut begins at another face than the one before ends at, or has one end only.
  bool change() const { return changes_ || last_ != first_ || sides_ % 2 == 1; }

 private:
  std::optional<int> first_, last_;
  std::size_t sides_ = 0;
  bool changes_ = false;
};

/// Whether a feature of a side from `vertex` counts on the side before: a pole that leaves the clip
/// box at an undefined vertex counts once.
bool is_counted_before(const EdgeFeature& feature, std::uint32_t vertex, const CellTree& tree) {
  return feature.kind == FeatureKind::Face && !tree.geometry().is_defined(vertex);
}

void add_kind(const EdgeFeature& feature, FeatureCount& count) {
  if (feature.kind == FeatureKind::Crease) ++count.creases;
  count.has_cliffs = count.has_cliffs || feature.kind == FeatureKind::Cliff;
  count.only_creases = count.only_creases && feature.kind == FeatureKind::Crease;
  count.is_continuous = count.is_continuous && feature.is_continuous();
  count.only_jumps =
      count.only_jumps && (feature.is_continuous() || feature.kind == FeatureKind::Jump);
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> sides_along_jumps(const Leaf& leaf,
                                                            const CellTree& tree) {
  using Ends = std::array<std::uint32_t, 2>;
  std::vector<Ends> sides;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) { sides.push_back({a, b}); });
  const auto is_along = [&](const Ends& side, const Ends& other) {
    const dvec2 a = tree.vertices().place_between(side[1]) - tree.vertices().place_between(side[0]);
    const dvec2 b =
        tree.vertices().place_between(other[1]) - tree.vertices().place_between(other[0]);
    return cross(a, b) == 0;
  };
  std::vector<Ends> along;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    if (!is_cut_at(sides[k][1], sides[k][0], tree)) continue;
    // From there to the next cut, on one side of the leaf.
    std::vector<Ends> stretch;
    for (std::size_t i = 1; i < sides.size(); ++i) {
      const Ends& side = sides[(k + i) % sides.size()];
      if (is_cut_at(side[0], side[1], tree)) {
        along.insert(along.end(), stretch.begin(), stretch.end());
        break;
      }
      if (tree.edges().feature(side[0], side[1])) break;
      if (!stretch.empty() && !is_along(stretch.front(), side)) break;
      stretch.push_back(side);
    }
  }
  return along;
}

FeatureCount count_features(const Leaf& leaf, const CellTree& tree) {
  FeatureCount count;
  std::vector<std::uint32_t> singular;
  FacesAround faces;
  bool has_jumps = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    add_singular_vertex(a, tree, singular);
    const EdgeCut* const side = tree.edges().find_cut(a, b);
    if (side == nullptr) return;
    count.leads_to_pole = count.leads_to_pole || side->pole != kNoIndex;
    const std::optional<EdgeFeature>& feature = side->feature;
    if (!feature || is_counted_before(*feature, a, tree)) return;
    has_jumps = has_jumps || feature->kind == FeatureKind::Jump;
    const bool on_side_of_u =
        tree.vertices().place_between(a).x == tree.vertices().place_between(b).x;
    const bool has_more = side->between_features.has_value();
    const std::size_t features = has_more ? 2 : 1;
    count.has_more = count.has_more || has_more;
    count.features += features;
    if (feature->kind == FeatureKind::Face)
      faces.add(feature->exit_beside(a), feature->exit_beside(b));
    (on_side_of_u ? count.on_sides_of_u : count.on_sides_of_v) += features;
    if (is_at_corner(*feature, leaf, tree)) {
      ++(on_side_of_u ? count.at_ends_of_u : count.at_ends_of_v);
    }
    add_kind(*feature, count);
  });
  if (has_jumps) {
    const JumpLines lines(leaf, tree);
    count.lines = lines.count();
    count.has_more = count.has_more || (lines.have_strips() && count.lines == 0);
  }
  count.changes_face = faces.change();
  count.is_thin_strip = count.creases == 1 && has_thin_strip(leaf, tree);
  count.singular_points = singular.size();
  if (count.features > 2) count.at_vertices = count_cut_vertices(leaf, tree);
  return count;
}

}  // namespace saddle
