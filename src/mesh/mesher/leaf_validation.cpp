#include "mesh/mesher/leaf_validation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/parallel.h"
#include "mesh/error/error_indicator.h"
#include "mesh/error/validate_in_chunks.h"
#include "mesh/grid/degenerate.h"
#include "mesh/grid/grid.h"
#include "mesh/model/tolerances.h"
#include "mesh/tree/cell_polygon.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

double thickness_of(const Leaf& leaf, const Grid& grid, const CellTree& tree) {
  if (!leaf.state.is_on_boundary()) return thickness(grid.mesh, leaf.samples.corner);
  const auto& position = grid.mesh.position;
  Bounds bounds;
  double area = 0;
  for (const Polygon& sub_polygon : sub_polygons(leaf, tree)) {
    const dvec3& first = position[sub_polygon[0].corner];
    for (std::size_t k = 1; k + 1 < sub_polygon.size(); ++k) {
      const dvec3 a = position[sub_polygon[k].corner] - first;
      const dvec3 b = position[sub_polygon[k + 1].corner] - first;
      area += glm::length(glm::cross(a, b)) / 2;
    }
    for (const PolygonCorner& corner : sub_polygon) bounds.add(position[corner.corner]);
  }
  return area > 0 ? area / bounds.diagonal() : 0;
}

bool LeafValidation::is_turned(std::size_t leaf) const {
  return turn_of_line(mesh_.sampled_errors[leaf].degrees) > limits_.normal_tolerance;
}

void LeafValidation::validate_new(std::vector<std::size_t> changed) {
  const auto& leaves = mesh_.leaves;
  const std::size_t validated = mesh_.sampled_errors.size();
  std::erase_if(changed, [validated](std::size_t k) { return k >= validated; });
  // Threads take different leaves: none may be there twice.
  std::ranges::sort(changed);
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  mesh_.reserve();
  for (std::size_t k = mesh_.allowed.size(); k < leaves.size(); ++k) {
    mesh_.allowed.push_back(tolerance_of(leaves[k], limits_.tolerance, tree_));
  }
  // The distance of a landmark is that from all leaves around it.
  const std::size_t at_a_time = landmarks_.any() ? leaves.size() : limits_.leaves_at_a_time;
  for (std::size_t k = validated; k < leaves.size(); ++k) {
    changed.push_back(k);
    if (changed.size() < at_a_time) continue;
    validate(changed, SingularCorners());
    changed.clear();
  }
  validate(changed, SingularCorners());
}

bool LeafValidation::revalidate() {
  const std::uint32_t now = tree_.revisions().next();
  const std::vector<std::size_t> changed =
      gather_in_chunks<std::size_t>(mesh_.leaves.size(), kInBatch, limits_.threads,
                                    [&](std::size_t k, std::vector<std::size_t>& some) {
                                      Leaf& leaf = mesh_.leaves[k];
                                      if (!tree_.revisions().has_changed(leaf, leaf.validated_at))
                                        return;
                                      leaf.validated_at = now;
                                      if (count_polygon_vertices(leaf, tree_) != leaf.polygon_size)
                                        some.push_back(k);
                                    });
  if (changed.empty()) return false;
  std::vector<double> degrees(changed.size());
  std::ranges::transform(changed, degrees.begin(),
                         [this](std::size_t k) { return mesh_.sampled_errors[k].degrees; });
  validate(changed, SingularCorners());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    mesh_.sampled_errors[changed[i]].degrees = degrees[i];
  }
  return true;
}

void LeafValidation::validate(std::span<const std::size_t> which, const SingularCorners& singular) {
  const std::uint32_t now = tree_.revisions().next();
  validate(which, singular, now, now);
}

/// The error of normals counts only in leaves thicker than kSeenTurn tolerances. `made`: the
/// revision of the triangles.
void LeafValidation::validate(std::span<const std::size_t> which, const SingularCorners& singular,
                              std::uint32_t now, std::uint32_t made) {
  for (const std::size_t k : which) mesh_.leaves[k].validated_at = now;
  LeafTriangles triangles =
      triangulate_leaves(mesh_.leaves, which, singular, grid_, tree_, limits_.threads);
  const ValidationCost cost =
      validate_in_chunks(surface_, grid_, tree_, limits_, {which, triangles}, mesh_);
  evaluations_ += cost.evaluations;
  tree_.effort().add_places(cost.evaluations);
  tree_.effort().looks() += cost.looks;
  mesh_.put(which, std::move(triangles), made);
  landmarks_.measure(which, mesh_);
  const auto is_thin = [this](std::size_t k) {
    return thickness_of(mesh_.leaves[k], grid_, tree_) <= kSeenTurn * mesh_.allowed[k];
  };
  parallel_chunks(which.size(), kInBatch, limits_.threads, [&](std::size_t begin, std::size_t end) {
    for (const std::size_t k : which.subspan(begin, end - begin)) {
      if (is_turned(k) && is_thin(k)) mesh_.sampled_errors[k].degrees = 0;
    }
  });
}

bool LeafValidation::validate_singular() {
  if (!tree_.geometry().has_singular()) return false;
  Mesh& mesh = grid_.mesh;
  const std::size_t count = mesh.position.size();
  MeshReport unused;
  const SingularCorners singular(mesh_.leaves, tree_, limits_.threads, normal_limits_, grid_,
                                 unused);
  // The corners with limits are removed again, and so the triangles at them are out of date.
  singular_validated_at_ = tree_.revisions().next();
  validate(singular.leaves(), singular, singular_validated_at_, RevisionClock::kNever);
  mesh.position.resize(count);
  mesh.normal.resize(count);
  mesh.uv.resize(count);
  mesh.point.resize(count);
  return true;
}

void LeafValidation::triangulate(MeshReport& report) {
  const auto& leaves = mesh_.leaves;
  const SingularCorners singular(leaves, tree_, limits_.threads, normal_limits_, grid_, report);
  std::vector<std::size_t> changed(singular.leaves().begin(), singular.leaves().end());
  std::erase_if(changed, [&](std::size_t k) {
    const std::uint32_t validated_at = leaves[k].validated_at;
    return validated_at == singular_validated_at_ &&
           !tree_.revisions().has_changed(leaves[k], validated_at);
  });
  validate(changed, singular);
  const std::vector<std::size_t> stale = gather_in_chunks<std::size_t>(
      leaves.size(), kInBatch, limits_.threads, [&](std::size_t k, std::vector<std::size_t>& some) {
        if (!has_lasting_triangles(k)) some.push_back(k);
      });
  mesh_.put(stale, triangulate_leaves(leaves, stale, singular, grid_, tree_, limits_.threads),
            tree_.revisions().next());
  mesh_.tidy_triangles();
}

/// Whether the triangles of a leaf's last validation are still those of its cell polygon.
bool LeafValidation::has_lasting_triangles(std::size_t number) const {
  const Leaf& leaf = mesh_.leaves[number];
  if (leaf.state.is_left_out()) return false;
  if (!tree_.revisions().has_changed(leaf, mesh_.made[number])) return true;
  if (!leaf.state.is_whole() || tree_.edges().may_be_crossed(leaf)) return false;
  // The change was beside the leaf if its polygon has as many vertices, and each is regular and a
  // point of its own.
  std::uint32_t count = 0;
  bool is_regular = true;
  for_sides(leaf, tree_, [&](std::uint32_t vertex, std::uint32_t) {
    ++count;
    is_regular =
        is_regular && tree_.geometry().is_regular(vertex) && grid_.mesh.point[vertex] == vertex;
  });
  return is_regular && count == leaf.polygon_size;
}

}  // namespace saddle
