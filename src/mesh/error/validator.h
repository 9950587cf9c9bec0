// Leaves measured on points that nobody has looked at before.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/distance_maximizer.h"
#include "mesh/error/limits.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/error/validation_points.h"
#include "mesh/tree/leaf_mesh.h"

namespace saddle {

class Validator {
 public:
  /// What is outside of the options' box does not count.
  Validator(const Surface& surface, const Grid& grid, const CellTree& tree,
            const RefineOptions& options)
      : surface_(surface),
        grid_(grid),
        tree_(tree),
        placer_(grid, tree),
        clip_(options.clip),
        normal_tolerance_(options.normal_tolerance),
        threads_(options.threads) {}

  /// Measures some leaves of a mesh from their triangles, of which there are as many: the largest
  /// deviation of each on a few points at random, which are the same whenever it is measured.
  void measure(ValidatedMesh& mesh, std::span<const std::size_t> which,
               const LeafTriangles& triangles);

  std::size_t evaluations() const { return evaluations_; }

 private:
  /// Measures the leaves that are as most are. Returns the numbers in `which` of the others.
  std::vector<std::size_t> validate_plain(ValidatedMesh& mesh, std::span<const std::size_t> which,
                                          const LeafTriangles& triangles,
                                          DistanceMaximizer& maxima);
  /// The same with leaves of any triangles, of `others`. Returns those of their samples that are
  /// still to be measured.
  std::vector<ValidationPoint> validate_several(ValidatedMesh& mesh,
                                                std::span<const std::size_t> which,
                                                std::span<const std::size_t> others,
                                                const LeafTriangles& triangles,
                                                DistanceMaximizer& maxima);
  bool is_good(const SampledError& sampled_error, double allowed) const {
    return sampled_error.distance <= allowed && sampled_error.degrees <= normal_tolerance_;
  }
  void validate_one_by_one(ValidatedMesh& mesh, std::span<const std::size_t> which,
                           const LeafTriangles& triangles,
                           std::span<const ValidationPoint> samples);
  void validate_sharp_bends(ValidatedMesh& mesh, std::span<const std::size_t> which,
                            const LeafTriangles& triangles);
  void validate_beside_creases(ValidatedMesh& mesh, std::span<const std::size_t> which,
                               const LeafTriangles& triangles, std::span<const std::size_t> others);
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
  unsigned threads_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
