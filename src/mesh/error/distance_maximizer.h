// Climbs from validation points to places where leaves are predicted to be farther from the
// surface.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "mesh/error/leaf_centres.h"
#include "mesh/error/validate_many.h"
#include "mesh/error/validated_mesh.h"
#include "mesh/model/tolerances.h"

namespace saddle {

/// Whether a leaf within its tolerance may be above it where `predicted` is predicted: above 1.02
/// times the error estimate, that threshold clamped to 0.95 to 1 tolerances.
bool may_be_missed(const ValidatedMesh& mesh, std::size_t leaf, double predicted);

/// In tolerances: climbs begin at the centres of leaves whose estimate is larger. Beside others the
/// surface would have to rise by two thirds.
inline constexpr double kFarCentre = 0.6;

/// Whether the surface may be farther from one of a whole leaf's triangles beside its centre.
bool is_missed_from_centre(const ValidatedMesh& mesh, std::size_t leaf, const LeafCentre& centre,
                           std::span<const Triangle> triangles, const Grid& grid);

class DistanceMaximizer {
 public:
  /// Errors outside of `clip` do not count.
  DistanceMaximizer(const Surface& surface, const Grid& grid, const std::optional<Bounds>& clip,
                    unsigned threads)
      : surface_(surface), grid_(grid), clip_(clip), threads_(threads) {}

  /// Adds a place to climb from, in a leaf with these triangles, which must outlive this.
  void add(std::size_t leaf, std::span<const Triangle> triangles, const dvec2& uv) {
    ascents_.push_back({leaf, triangles, uv, -1, {0, uv}});
  }

  /// Adds the places where a leaf of two triangles was measured.
  void add_places(std::size_t leaf, std::span<const Triangle> triangles,
                  const TwoTriangles& measured);

  /// Follows predictions until none is higher, a leaf is above its tolerance, or for five steps.
  /// Adds the distances found to the mesh.
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
  std::vector<Ascent> ascents_;
  std::size_t evaluations_ = 0;
};

}  // namespace saddle
