#include "mesh/error/left_out_leaves.h"

#include <algorithm>
#include <optional>
#include <span>

#include "mesh/model/clip.h"
#include "mesh/model/triangle_tree.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/feature_count.h"

namespace saddle {

namespace {

/// Places of the sheets around a leaf. A vertex with a value of its own is on none: a feature cuts
/// a side of the leaf at its place, or may do so where the side has several.
std::vector<dvec2> places_around(const Leaf& leaf, const CellTree& tree) {
  std::vector<std::uint32_t> cut;
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    const auto feature = tree.edges().feature(a, b);
    const auto place = [&](std::uint32_t vertex) { return tree.vertices().place_between(vertex); };
    for (const std::uint32_t end : {a, b}) {
      const bool is_cut = feature && place(feature->beside(end)) == place(end);
      if (is_cut || tree.edges().has_more(a, b)) cut.push_back(end);
    }
  });
  std::vector<dvec2> places;  // in their order around the leaf
  for_sides(leaf, tree, [&](std::uint32_t a, std::uint32_t b) {
    if (const auto between = tree.edges().between_features(a, b)) places.push_back(*between);
    const auto feature = tree.edges().feature(a, b);
    for (std::size_t k = 0; feature && k < feature->strips; ++k) {
      if (!is_wide_strip(*feature, k, {a, b}, tree)) continue;  // a line, if the leaf is too small
      const auto [first, second] = feature->on_strip(k, a);
      places.push_back(0.5 * (tree.mesh().uv[first] + tree.mesh().uv[second]));
    }
    for (const std::uint32_t end : {a, b}) {
      const bool is_on_sheet = tree.geometry().is_defined(end) && std::ranges::count(cut, end) == 0;
      if (is_on_sheet) places.push_back(tree.mesh().uv[feature ? feature->beside(end) : end]);
    }
  });
  return places;
}

/// Adds the middles between places across the leaf from each other: a strip that crosses a leaf may
/// be on its sides where others have triangles, and be far from them inside. Between places along
/// a jump, the surface may have a value of its own.
void append_middles(std::vector<dvec2>& places) {
  const std::size_t across = places.size() / 2;
  for (std::size_t k = 0; k < across; ++k) places.push_back(0.5 * (places[k] + places[k + across]));
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

}  // namespace

std::vector<LeftOutLeaf> measure_left_out(const ValidatedMesh& mesh,
                                          const std::optional<Bounds>& clip, unsigned threads,
                                          const CellTree& tree) {
  std::vector<LeftOutLeaf> result;
  std::vector<std::vector<dvec2>> places;
  std::vector<dvec2> all_places;
  for (std::size_t k = 0; k < mesh.leaves.size(); ++k) {
    if (!mesh.leaves[k].state.is_too_small()) continue;
    result.push_back({k, {}});
    places.push_back(places_around(mesh.leaves[k], tree));
    if (!has_cut(FeatureKind::Jump, mesh.leaves[k], tree)) append_middles(places.back());
    all_places.insert(all_places.end(), places.back().begin(), places.back().end());
  }
  if (result.empty()) return result;
  const std::vector<Triangle> triangles = triangles_of_others(mesh);
  if (triangles.empty()) return {};
  const TriangleTree whole(tree.mesh().position, triangles, tree.surface().tangents.count);
  const std::vector<dvec3> points = evaluate_positions(tree.surface(), all_places, threads);
  std::size_t next = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (const dvec2& uv : places[i]) {
      const dvec3& position = points[next++];
      if (!is_seen(clip, position)) continue;
      const double distance = whole.distance(position);
      if (distance > result[i].farthest.distance) result[i].farthest = {distance, uv};
    }
  }
  return result;
}

}  // namespace saddle
