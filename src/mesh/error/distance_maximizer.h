// Looks for places where leaves are farther off than where they were measured.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/validated_mesh.h"

namespace saddle {

/// Whether a leaf that was found to be near enough may be too far off where so much is foreseen:
/// more than is allowed, or nearly as much and more than its tests know of.
bool may_be_missed(const ValidatedMesh& mesh, std::size_t leaf, double predicted);

class DistanceMaximizer {
 public:
  /// What is outside of `clip` does not count.
  DistanceMaximizer(const Surface& surface, const Grid& grid, const std::optional<Bounds>& clip,
                    unsigned threads)
      : surface_(surface), grid_(grid), clip_(clip), threads_(threads) {}

  /// A place from where more is foreseen, in a leaf with these triangles, which must outlive this.
  void add(std::size_t leaf, std::span<const Triangle> triangles, const dvec2& uv) {
    maxima_.push_back({leaf, triangles, uv, -1, {0, uv}});
  }

  /// Follows what is foreseen until no more is, a leaf is found to be too far off, or a few steps
  /// are done, and adds the distances that are found to the mesh.
  void climb(ValidatedMesh& mesh);

  std::size_t evaluations() const { return evaluations_; }

 private:
  struct Ascent {
    std::size_t leaf;
    std::span<const Triangle> triangles;
    dvec2 uv;
    double distance;  ///< there; negative: not known yet
    Predicted predicted;
  };
  void evaluate_predicted(ValidatedMesh& mesh);

  const Surface& surface_;
  const Grid& grid_;
  const std::optional<Bounds>& clip_;
  unsigned threads_;
  std::vector<Ascent> maxima_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
