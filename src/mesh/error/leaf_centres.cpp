#include "mesh/error/leaf_centres.h"

#include "mesh/tree/cell_tree.h"
#include "surface/normal.h"

namespace saddle {

LeafCentres::LeafCentres(const Surface& surface, const ValidatedMesh& mesh,
                         std::span<const std::size_t> which, double least, const CellTree& tree,
                         unsigned threads)
    : mesh_(mesh), which_(which), least_(least), tree_(tree) {
  std::vector<double> u;
  std::vector<double> v;
  for (std::size_t i = 0; i < which.size(); ++i) {
    const Leaf& leaf = mesh.leaves[which[i]];
    if (leaf.samples.centre != SampleVertices::kUnasked || !(leaf.known_error > least)) continue;
    numbers_.resize(which.size());
    numbers_[i] = static_cast<std::uint32_t>(u.size());
    const dvec2 uv = tree.vertices().parameters(leaf.middle());
    u.push_back(uv.x);
    v.push_back(uv.y);
  }
  if (u.empty()) return;
  const NormalColumns columns = evaluate_normals(surface, u, v, threads);
  for (std::size_t i = 0; i < u.size(); ++i) {
    const ColumnPoint point = column_point(columns, i, surface.flip);
    evaluated_.push_back(point.is_regular
                             ? std::optional(LeafCentre{{u[i], v[i]}, point.position, point.normal})
                             : std::nullopt);
  }
}

std::optional<LeafCentre> LeafCentres::of(std::size_t i) const {
  const Leaf& leaf = mesh_.leaves[which_[i]];
  if (!(leaf.known_error > least_)) return std::nullopt;
  const std::uint32_t centre = leaf.samples.centre;
  if (centre == SampleVertices::kUnasked) return evaluated_[numbers_[i]];
  if (!tree_.geometry().is_regular(centre)) return std::nullopt;
  const Mesh& mesh = tree_.mesh();
  return LeafCentre{mesh.uv[centre], mesh.position[centre], mesh.normal[centre]};
}

}  // namespace saddle
