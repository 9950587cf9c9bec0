// A posteriori validation: measures the errors of a mesh's leaves at points other than the samples
// of the error indicator. It climbs to where larger errors are predicted, and adds distances at
// creases, sharp bends and boundaries. The result is a lower bound; mesh/proof has upper ones.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/error/validation_points.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

class CellTree;
class DistanceMaximizer;

class Validator {
 public:
  /// Errors outside of the limits' clip box do not count.
  Validator(const Surface& surface, const Grid& grid, const CellTree& tree,
            const CellLimits& limits)
      : surface_(surface),
        grid_(grid),
        tree_(tree),
        placer_(grid, tree),
        clip_(limits.clip),
        normal_tolerance_(limits.normal_tolerance) {}

  /// Measures some leaves of a mesh against their triangles, one range for each: the largest error
  /// of a leaf at a few random points, which are always the same for the same leaf. Changes nothing
  /// of the mesh but their sampled errors, which are there.
  void measure(ValidatedMesh& mesh, std::span<const std::size_t> which,
               const PartOfTriangles& triangles);

  std::size_t evaluations() const { return evaluations_; }
  /// Points and boxes in searches, which cost more the longer the formula is.
  std::size_t looks() const { return looks_; }

 private:
  /// Validates leaves of two triangles without edge features. Returns the numbers in `which` of the
  /// others.
  std::vector<std::size_t> validate_plain(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                          const PartOfTriangles& triangles,
                                          DistanceMaximizer& maxima);
  /// Validates leaves of any triangles, with the numbers `others`. Returns the points to which only
  /// sampled_error() applies.
  std::vector<ValidationPoint> validate_several(ValidatedMesh& mesh,
                                                std::span<const std::size_t> which,
                                                std::span<const std::size_t> others,
                                                const PartOfTriangles& triangles,
                                                DistanceMaximizer& maxima);
  bool is_good(const SampledError& sampled_error, double allowed) const {
    return sampled_error.distance <= allowed && sampled_error.degrees <= normal_tolerance_;
  }
  void validate_one_by_one(ValidatedMesh& mesh, std::span<const std::size_t> which,
                           const PartOfTriangles& triangles,
                           std::span<const ValidationPoint> samples);
  void validate_sharp_bends(ValidatedMesh& mesh, std::span<const std::size_t> which,
                            const PartOfTriangles& triangles);
  void validate_beside_creases(ValidatedMesh& mesh, std::span<const std::size_t> which,
                               const PartOfTriangles& triangles,
                               std::span<const std::size_t> others);
  void validate_across_faces(ValidatedMesh& mesh, std::span<const std::size_t> which,
                             const PartOfTriangles& triangles);
  void validate_omitted_corners(ValidatedMesh& mesh, std::size_t number,
                                std::span<const Triangle> triangles) const;
  bool crosses_box(std::span<const Triangle> triangles) const;
  SampledError sampled_error_of(const Leaf& leaf, std::span<const Triangle> triangles,
                                const dvec2& uv, const SurfacePoint& point, double known) const;

  const Surface& surface_;
  const Grid& grid_;
  const CellTree& tree_;
  PointPlacer placer_;
  const std::optional<Bounds>& clip_;
  double normal_tolerance_;
  std::size_t evaluations_ = 0;
  std::size_t looks_ = 0;
};

}  // namespace saddle
