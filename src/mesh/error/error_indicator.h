// How good a leaf of a refined grid is as it stands: from the middles of its sides and its centre.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "mesh/error/limits.h"
#include "mesh/model/counterexample.h"
#include "mesh/tree/cell_tree.h"

namespace saddle {

/// How bad a leaf is along u, along v and at its centre; 1 is just good enough. Errors fall with
/// the square of a leaf's size and angles with the size itself: the square of an angle's share is
/// comparable.
struct ErrorRatios {
  double along_u = 0;
  double along_v = 0;
  double centre = 0;
  double worst() const { return std::max({along_u, along_v, centre}); }
};

/// The scores of distances and of normals.
struct CellError {
  ErrorRatios distance;
  ErrorRatios gap;  ///< distances from the middles of chords: of a wall, its height
  ErrorRatios turn;
  bool is_folded = false;  ///< the normals at two neighbouring samples face opposite ways
  bool may_jump = false;   ///< a sample is far from the middle of its chord
};

inline ErrorRatios worse(const ErrorRatios& a, const ErrorRatios& b) {
  return {std::max(a.along_u, b.along_u), std::max(a.along_v, b.along_v),
          std::max(a.centre, b.centre)};
}

/// Asks the cell tree for those samples of a leaf that are not known.
void request_samples(Leaf& leaf, CellTree& tree);

/// What is allowed of a leaf, by its corners.
double tolerance_of(const Leaf& leaf, const Tolerance& tolerance, const CellTree& tree);

/// How wide a leaf with these corners is in the direction in which it is narrow: of a parallelogram
/// its smaller height. Not finite where a corner is not.
double thickness(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner);

/// How many of the nine samples of a leaf are defined.
int count_defined(const CellTree& tree, const Leaf& leaf);

/// Judges leaves whose samples are known.
class ErrorIndicator {
 public:
  ErrorIndicator(const RefineOptions& options, const Grid& grid, const CellTree& tree)
      : options_(options), grid_(grid), mesh_(grid.mesh), tree_(tree) {
    if (!options.clip) return;
    const double margin = grid.mesh.bounds.diagonal();
    far_ = Bounds{options.clip->low - margin, options.clip->high + margin};
  }

  /// What is allowed of a leaf.
  double allowed(const Leaf& leaf) const;
  /// Whether a side is on a line that is seen: then its distance counts in any direction.
  bool is_seen(const Leaf& leaf, std::size_t side) const;

  /// Of a leaf all of whose samples are defined.
  CellError estimate(const Leaf& leaf) const;

  /// Of angles, by the squares of their tangents.
  ErrorRatios turn_ratios(const ErrorRatios& squares_of_tangents) const;

  /// Whether the samples of a leaf are all within what may be missing of each other: whatever cuts
  /// it, nobody sees how.
  bool is_too_small_to_see(const Leaf& leaf) const;

  /// Whether a leaf that passes its tests misses the surface at a counterexample, or a hole there.
  bool misses(const Leaf& leaf, const Counterexample& counterexample) const;
  /// Which way to halve it then: the one along which the surface bends more at the counterexample.
  bool splits_u(const Leaf& leaf, const Counterexample& counterexample) const;

  /// Which way to halve a leaf that failed.
  bool splits_u(const Leaf& leaf, const ErrorRatios& ratios) const;

  /// Which way to halve a leaf that the boundary crosses: the one along which samples cease to be
  /// defined more often, so that halves are on one side of it; else, and where that has made it a
  /// sliver along the boundary, the longer one.
  bool splits_boundary_u(const Leaf& leaf) const;

  /// Whether nothing of a leaf will be left; samples that are not defined do not count.
  bool is_clipped(const Leaf& leaf) const;

  /// Whether all samples are clipped, if not by the same face: nothing will be left of a leaf that
  /// a pole goes through.
  bool is_outside(const Leaf& leaf) const;

 private:
  dvec3 seen_position(std::uint32_t vertex) const;
  using Corners = std::array<std::uint32_t, 4>;
  struct ChordSample;

  std::vector<dvec3> defined_positions(const SampleVertices& samples) const;
  double diameter(const Corners& corner) const;
  bool is_regular(std::uint32_t vertex) const { return tree_.geometry().is_regular(vertex); }
  bool has_opposed(const SampleVertices& samples) const;
  /// `vertices`: the chord's ends and the sample.
  double distance_of_sample(const ChordSample& arc, const std::array<std::uint32_t, 3>& vertices,
                            bool border) const;
  std::size_t cut_from(const Corners& corner) const;
  double distance_from_triangles(const Leaf& leaf, std::size_t first) const;
  double bulge_of_triangles(const SampleVertices& samples, std::size_t first) const;
  double square_of_tangent(std::uint32_t a, std::uint32_t b, std::uint32_t sample) const;
  double turn_ratio(double square_of_tangent) const;

  const RefineOptions& options_;
  const Grid& grid_;
  std::optional<Bounds> far_;  ///< beyond it nothing matters
  const Mesh& mesh_;
  const CellTree& tree_;
};

}  // namespace saddle
