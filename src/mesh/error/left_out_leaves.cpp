#include "mesh/error/left_out_leaves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "base/numbers.h"
#include "base/parallel.h"
#include "base/random.h"
#include "mesh/distance/nearest_triangles.h"
#include "mesh/grid/grid.h"
#include "mesh/model/clip.h"
#include "mesh/model/sample_places.h"
#include "mesh/model/tolerances.h"
#include "mesh/model/triangle_tree.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// A place of the surface. Beside a feature its position is that of a vertex: rounding may give the
/// parameters another one.
struct Place {
  dvec2 uv;
  std::optional<dvec3> position = {};
};

/// Vertices that may have values of their own, on no sheet: a feature cuts a side of the leaf at
/// their place, or may do so where the side has several.
std::vector<std::uint32_t> cut_corners(const Leaf& leaf, const CellTree& tree) {
  std::vector<std::uint32_t> cut;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    const auto place = [&](std::uint32_t vertex) { return tree.vertices().place_between(vertex); };
    for (const std::uint32_t end : {a, b}) {
      const bool is_cut = feature && place(feature->beside(end)) == place(end);
      if (is_cut || tree.edges().has_more(a, b)) cut.push_back(end);
    }
  });
  return cut;
}

/// The last place of a sheet on the way from a neighbour to the feature of a side.
Place last_place(std::uint32_t neighbour, const EdgeFeature& feature, const Mesh& mesh) {
  const std::uint32_t vertex = feature.beside(neighbour);
  // The rim itself may have a value of its own, which is no part of a sheet.
  if (feature.is_boundary()) return {glm::mix(mesh.uv[vertex], mesh.uv[neighbour], kNearly)};
  return {mesh.uv[vertex], mesh.position[vertex]};
}

/// Whether a strip between two jumps of a side enters a leaf.
bool has_strip(const Leaf& leaf, const CellTree& tree) {
  bool has = false;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature || feature->kind != FeatureKind::Jump) return;
    for (std::size_t k = 0; k < feature->strips; ++k)
      has = has || is_wide_strip(*feature, k, {a, b}, tree);
  });
  return has;
}

/// Vertices that sides without features lead to from such ones: all may be on a line with values of
/// its own, as that of sign(u)*sign(v) at v=0.
std::vector<std::uint32_t> on_lines_of(std::span<const std::uint32_t> cut, const Leaf& leaf,
                                       const CellTree& tree) {
  std::vector<std::uint32_t> on_lines(cut.begin(), cut.end());
  const auto is_on_line = [&](std::uint32_t vertex) {
    return std::ranges::count(on_lines, vertex) > 0;
  };
  for (std::size_t before = 0; before < on_lines.size();) {
    before = on_lines.size();
    for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
      if (tree.edges().feature(a, b) || is_on_line(a) == is_on_line(b)) return;
      on_lines.push_back(is_on_line(a) ? b : a);
    });
  }
  return on_lines;
}

/// A place in a box, on none of its diagonals: formulas often have special values there.
dvec2 somewhere_in(const ParameterBox& box) {
  return glm::mix(box.low, box.high, dvec2(random_unit(0), random_unit(1)));
}

/// Places of the sheets around a leaf, in their order.
std::vector<Place> places_around(const Leaf& leaf, const CellTree& tree) {
  const std::vector<std::uint32_t> cut = cut_corners(leaf, tree);
  const std::vector<std::uint32_t> on_lines = on_lines_of(cut, leaf, tree);
  const Mesh& mesh = tree.mesh();
  const dvec2 inside = somewhere_in(tree.box(leaf));
  const auto place_of = [&](std::uint32_t vertex, const std::optional<EdgeFeature>& feature) {
    const Place place = feature ? last_place(vertex, *feature, mesh)
                                : Place{mesh.uv[vertex], mesh.position[vertex]};
    if (std::ranges::count(on_lines, vertex) == 0) return place;
    return Place{glm::mix(place.uv, inside, kNearly)};
  };
  std::vector<Place> places;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    if (const auto between = tree.edges().between_features(a, b)) places.push_back({*between});
    const auto feature = tree.edges().feature(a, b);
    for (std::size_t k = 0; feature && k < feature->strips; ++k) {
      if (!is_wide_strip(*feature, k, {a, b}, tree)) continue;  // a line, if the leaf is too small
      const auto [first, second] = feature->on_strip(k, a);
      places.push_back({0.5 * (mesh.uv[first] + mesh.uv[second])});
    }
    for (const std::uint32_t end : {a, b}) {
      if (!tree.geometry().is_defined(end) || std::ranges::count(cut, end) > 0) continue;
      places.push_back(place_of(end, feature));
    }
  });
  return places;
}

/// Where the surface leaves the clip box on the sides of a leaf, on its way to the leaf's pole: the
/// needle before it may be long.
std::vector<Place> places_at_faces(const Leaf& leaf, const CellTree& tree) {
  std::vector<Place> places;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    if (!feature || feature->kind != FeatureKind::Face) return;
    for (const std::uint32_t vertex : {feature->beside_first, feature->beside_second})
      places.push_back({tree.mesh().uv[vertex], tree.mesh().position[vertex]});
  });
  return places;
}

/// Adds the middles between places across the leaf from each other: a strip that crosses a leaf may
/// be on its sides where others have triangles, and be far from them inside. Between places along
/// a jump, the surface may have a value of its own: middles are a little aside.
void append_middles(const dvec2& size_of_leaf, std::vector<Place>& places) {
  const std::size_t across = places.size() / 2;
  const dvec2 aside = kNearly * size_of_leaf * dvec2(1, -1);
  for (std::size_t k = 0; k < across; ++k)
    places.push_back({0.5 * (places[k].uv + places[k + across].uv) + aside});
}

std::vector<Triangle> triangles_of_others(const ValidatedMesh& mesh) {
  std::vector<Triangle> triangles;
  for (std::size_t k = 0; k < mesh.triangles.ranges.size(); ++k) {
    const std::span<const Triangle> own = mesh.triangles.of(k);
    if (!mesh.leaves[k].state.is_left_out())
      triangles.insert(triangles.end(), own.begin(), own.end());
  }
  return triangles;
}

/// Whether the features of a leaf leave it no triangles, though it is not left out. Beside a pole
/// they would be walls; where rounding makes the pole, they would be the surface.
bool is_emptied(const ValidatedMesh& mesh, std::size_t leaf) {
  const LeafState& state = mesh.leaves[leaf].state;
  return state.is_cut_by_feature() && !state.is_left_out() && mesh.triangles.of(leaf).empty();
}

/// Measures places of left-out leaves from the triangles of the others. Distances of less than
/// `enough` may be any up to that: among many sheets an exact one takes a visit of most.
class Measurer {
 public:
  Measurer(const Grid& grid, const std::optional<Bounds>& clip, unsigned threads,
           const CellTree& tree, double enough)
      : grid_(grid), clip_(clip), threads_(threads), enough_(enough), tree_(tree) {}

  void add(std::size_t leaf, std::span<const Place> places) {
    result_.push_back({leaf, {}});
    for (const Place& place : places) take_later(result_.size() - 1, place);
  }

  /// Adds a lattice of places in the leaf added last, and a compass search from the farthest one.
  /// Places are jittered: at even shares and on diagonals formulas often have special values.
  void add_inside(const ParameterBox& box) {
    const std::size_t leaf = result_.size() - 1;
    result_[leaf].farthest.uv = box.middle();
    searched_.push_back({leaf, box, kCompassStep});
    std::uint64_t key = 0;
    const auto jittered = [&key](double share) {
      return (1 - kSampleJitter) * share + kSampleJitter * random_unit(key++);
    };
    for (const double u : kAllAlongLine) {
      for (const double v : kAllAlongLine) {
        const double share_u = jittered(u);
        const double share_v = jittered(v);
        take_later(leaf, {glm::mix(box.low, box.high, dvec2(share_u, share_v))});
      }
    }
  }

  std::vector<LeftOutLeaf> run(const ValidatedMesh& mesh) {
    if (result_.empty()) return {};
    const std::vector<Triangle> triangles = triangles_of_others(mesh);
    if (triangles.empty()) return {};
    // Sorting the triangles takes a pass for each level of their tree.
    const bool is_few =
        searched_.empty() &&
        places_.size() <= static_cast<std::size_t>(std::bit_width(triangles.size()));
    if (is_few) {
      in_order_.emplace(grid_, triangles);
    } else {
      sorted_.emplace(tree_.mesh().position, triangles, threads_, tree_.surface().tangents.count);
    }
    measure();
    // Nothing is far off where all is beyond the clip box or undefined, either.
    std::erase_if(searched_, [this](const Searched& of) {
      return result_[of.leaf].farthest.distance <= enough_;
    });
    for (int round = 0; !searched_.empty() && round < kHalvingsToNearly; ++round) search();
    return std::move(result_);
  }

 private:
  struct Searched {
    std::size_t leaf;  ///< its number in the result
    ParameterBox box;
    double step;  ///< in shares of its sides
  };

  /// A round of compass searches. On a line the surface may have a value of its own, as sign(u) at
  /// 0: the smaller distance of a place and of one a little inside counts.
  void search() {
    std::vector<dvec2> uv;
    for (const auto& [leaf, box, step] : searched_) {
      const dvec2& from = result_[leaf].farthest.uv;
      for (const dvec2& way : kFourWays) {
        const dvec2 there = nearest_in(box, from + step * way * (box.high - box.low));
        uv.insert(uv.end(), {there, glm::mix(there, somewhere_in(box), kNearly)});
      }
    }
    const std::vector<double> distances =
        distances_of(evaluate_positions(tree_.surface(), uv, threads_));
    std::size_t next = 0;
    for (Searched& of : searched_) {
      PlacedError& farthest = result_[of.leaf].farthest;
      const double before = farthest.distance;
      for (const std::size_t end = next + 2 * kFourWays.size(); next < end; next += 2) {
        const std::size_t place = distances[next + 1] < distances[next] ? next + 1 : next;
        if (distances[place] > farthest.distance) farthest = {distances[place], uv[place]};
      }
      if (!(farthest.distance > before)) of.step *= 0.5;
    }
  }

  /// 0 where the surface is undefined or clipped.
  std::vector<double> distances_of(std::span<const dvec3> positions) const {
    std::vector<double> distances(positions.size(), 0);
    parallel_chunks(positions.size(), kSearchedTogether, threads_,
                    [&](std::size_t begin, std::size_t end) {
                      for (std::size_t k = begin; k < end; ++k) {
                        if (is_seen(clip_, positions[k])) distances[k] = distance_of(positions[k]);
                      }
                    });
    return distances;
  }

  double distance_of(const dvec3& position) const {
    if (sorted_) return sorted_->distance(position, kInfinity, enough_);
    std::size_t visited = 0;
    return in_order_->nearest(position, enough_, {}, visited).distance;
  }

  void take_later(std::size_t leaf, const Place& place) {
    leaves_.push_back(leaf);
    places_.push_back(place);
  }

  void measure() {
    std::vector<dvec2> uv(places_.size());
    std::ranges::transform(places_, uv.begin(), &Place::uv);
    std::vector<dvec3> positions = evaluate_positions(tree_.surface(), uv, threads_);
    for (std::size_t k = 0; k < places_.size(); ++k)
      positions[k] = places_[k].position.value_or(positions[k]);
    const std::vector<double> distances = distances_of(positions);
    for (std::size_t k = 0; k < places_.size(); ++k) {
      PlacedError& farthest = result_[leaves_[k]].farthest;
      if (distances[k] > farthest.distance) farthest = {distances[k], uv[k]};
    }
  }

  const Grid& grid_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  double enough_;
  const CellTree& tree_;
  std::optional<TriangleTree> sorted_;        // of the triangles, if there is much to measure
  std::optional<NearestTriangles> in_order_;  // of the same, if there is little
  std::vector<LeftOutLeaf> result_;
  std::vector<Searched> searched_;
  std::vector<Place> places_;        // to be measured
  std::vector<std::size_t> leaves_;  // of each, in the result
};

void add_too_small(const ValidatedMesh& mesh, const CellTree& tree, Measurer& measurer) {
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    if (!leaf.state.is_too_small()) continue;
    const ParameterBox box = tree.box(leaf);
    std::vector<Place> places = places_around(leaf, tree);
    if (!has_cut(FeatureKind::Jump, leaf, tree)) append_middles(box.size(), places);
    measurer.add(k, places);
    // Where a jump meets the boundary or another jump, sheets may end far from the sides.
    if (leaf.state.cut() == LeafCut::BoundaryAndFeature || has_strip(leaf, tree))
      measurer.add_inside(box);
  }
}

/// Adds the largest of the emptied leaves that may be seen: beside waves there are hundreds of
/// thousands. Without a clip box, the surface has no end beside a pole.
void add_emptied(const ValidatedMesh& mesh, const std::optional<Bounds>& clip, const CellTree& tree,
                 Measurer& measurer) {
  const auto may_be_seen = [&](const Leaf& leaf) {
    return clip ? !is_beyond(*clip, corner_positions(leaf, tree))
                : !has_cut(FeatureKind::Pole, leaf, tree);
  };
  std::vector<std::size_t> emptied;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    if (is_emptied(mesh, k) && may_be_seen(mesh.leaves[k])) emptied.push_back(k);
  }
  const auto area = [&](std::size_t k) {
    const Leaf& leaf = mesh.leaves[k];
    return std::uint64_t{leaf.size_u()} * leaf.size_v();
  };
  std::ranges::stable_sort(emptied, std::ranges::greater(), area);
  if (emptied.size() > kMostOpen) emptied.resize(kMostOpen);
  for (const std::size_t k : emptied) {
    // Corners may have values of their own, beside a jump that the pole hides.
    measurer.add(k, {});
    measurer.add_inside(tree.box(mesh.leaves[k]));
  }
}

void add_needles(const ValidatedMesh& mesh, const CellTree& tree, Measurer& measurer) {
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    const Leaf& leaf = mesh.leaves[k];
    if (!leaf.state.is_left_out() || leaf.state.is_too_small()) continue;
    const std::vector<Place> places = places_at_faces(leaf, tree);
    if (!places.empty()) measurer.add(k, places);
  }
}

}  // namespace

std::vector<LeftOutLeaf> measure_too_small(const ValidatedMesh& mesh, const Grid& grid,
                                           const std::optional<Bounds>& clip, unsigned threads,
                                           const CellTree& tree) {
  Measurer measurer(grid, clip, threads, tree, 0);
  add_too_small(mesh, tree, measurer);
  return measurer.run(mesh);
}

std::vector<LeftOutLeaf> measure_left_out(const ValidatedMesh& mesh, double known, const Grid& grid,
                                          const std::optional<Bounds>& clip, unsigned threads,
                                          const CellTree& tree) {
  Measurer measurer(grid, clip, threads, tree, kClimbedShare * known);
  add_too_small(mesh, tree, measurer);
  add_emptied(mesh, clip, tree, measurer);
  if (clip) add_needles(mesh, tree, measurer);
  return measurer.run(mesh);
}

}  // namespace saddle
