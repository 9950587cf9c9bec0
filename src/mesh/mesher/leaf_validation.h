// Keeps the sampled errors of a mesh's leaves up to date: validates new leaves, and others again
// whose triangles changed with their neighbours.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/mesher/leaf_landmarks.h"
#include "mesh/model/mesh_report.h"
#include "mesh/tree/singular_corners.h"

namespace saddle {

class CellTree;

/// The thickness of a leaf, in units of length; with a boundary, the area of its sub-polygons
/// divided by their diagonal.
double thickness_of(const Leaf& leaf, const Grid& grid, const CellTree& tree);

class LeafValidation {
 public:
  LeafValidation(const Surface& surface, const CellLimits& limits, Grid& grid, CellTree& tree,
                 LeafLandmarks& landmarks, ValidatedMesh& mesh)
      : surface_(surface),
        limits_(limits),
        grid_(grid),
        tree_(tree),
        landmarks_(landmarks),
        mesh_(mesh) {}

  /// Validates the leaves without sampled errors, and others whose features changed.
  void validate_new(std::vector<std::size_t> changed);
  /// Validates the distances of leaves again whose cell polygons have new vertices. Their errors of
  /// normals stay. False if there are no such leaves.
  bool revalidate();
  /// Validates leaves again that got inner vertices.
  void validate_again(std::span<const std::size_t> which) { validate(which, SingularCorners()); }
  /// Validates the leaves at singular vertices with the limits of their normals. The limits are not
  /// kept: leaves may still change. False if there are no singular vertices.
  bool validate_singular();

  /// The triangles of all leaves, with the limits of normals at singular vertices.
  void triangulate(MeshReport& report);

  /// Whether the normals of a leaf turn by more than is allowed.
  bool is_turned(std::size_t leaf) const;
  /// Places at which the surface was evaluated.
  std::size_t evaluations() const { return evaluations_; }

 private:
  void validate(std::span<const std::size_t> which, const SingularCorners& singular);
  void validate(std::span<const std::size_t> which, const SingularCorners& singular,
                std::uint32_t now, std::uint32_t made);
  bool has_lasting_triangles(std::size_t leaf) const;

  const Surface& surface_;
  const CellLimits& limits_;
  Grid& grid_;
  CellTree& tree_;
  LeafLandmarks& landmarks_;
  ValidatedMesh& mesh_;
  LastLimits normal_limits_;
  std::uint32_t singular_validated_at_ = 0;  ///< the last revision of validate_singular()
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
