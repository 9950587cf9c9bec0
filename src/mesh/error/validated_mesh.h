// The leaves of a mesh and how far off they are.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/error/sampled_error.h"
#include "mesh/tree/cell_tree.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

/// The leaves of a mesh, what is allowed of them, what they were last found to deviate by and the
/// triangles that this was of.
struct ValidatedMesh {
  std::vector<Leaf> leaves;
  /// As many as leaves, or fewer: the rest is not measured yet.
  std::vector<SampledError> sampled_errors;
  std::vector<double> allowed;
  /// As many ranges as deviations. Triangles that were replaced stay, in no range.
  LeafTriangles triangles;
  std::vector<std::uint32_t> made;  ///< when triangles were: RevisionClock::next()

  /// How far off a leaf is, in what is allowed.
  double off(std::size_t leaf) const { return sampled_errors[leaf].distance / allowed[leaf]; }
  /// Whether no more is known than is allowed.
  bool is_near(std::size_t leaf) const { return sampled_errors[leaf].distance <= allowed[leaf]; }
  /// A distance that was found at a leaf.
  void add(std::size_t leaf, double distance) {
    double& worst = sampled_errors[leaf].distance;
    worst = distance > worst ? distance : worst;
  }
  /// Files the triangles of some leaves.
  void put(std::span<const std::size_t> which, const LeafTriangles& newer, std::uint32_t now);
  /// The triangles of all leaves, and no others.
  LeafTriangles all_triangles() const;
  /// Takes leaves out; `which` ascending. The others stay in their order.
  void remove(std::span<const std::size_t> which);
};

}  // namespace saddle
