// The error indicator: estimates how far a leaf's two triangles would be from the surface, and how
// far their normals, from nine samples: its corners, the middles of its sides and its centre. A
// leaf above its tolerance is split. Validation (mesh/error/validator) measures the error
// elsewhere. Source of the terms: R. Verfuerth, "A posteriori error estimation techniques for
// finite element methods", 2013.
#pragma once

#include <algorithm>
#include <array>
#include <optional>

#include "mesh/error/limits.h"
#include "mesh/model/counterexample.h"
#include "mesh/model/mesh.h"
#include "mesh/tree/leaf.h"

namespace saddle {

class CellTree;
struct Grid;

/// Errors of a leaf along u, along v and at its centre, as parts of its tolerance. Distances fall
/// with the square of a leaf's size, angles with the size itself. The ratio of an angle is
/// therefore the square of its part of the normal tolerance.
struct ErrorRatios {
  double along_u = 0;
  double along_v = 0;
  double centre = 0;
  double worst() const { return std::max({along_u, along_v, centre}); }
};

/// The error ratios of distances and of normals.
struct CellError {
  ErrorRatios distance;
  ErrorRatios gap;  ///< from the middle of each chord; the height of a steep front
  ErrorRatios turn;
  bool is_folded = false;  ///< normals of two neighbouring samples are over 90 degrees apart
  bool may_jump = false;   ///< a sample is farther from its chord's middle than kSmallArc
};

inline ErrorRatios worse(const ErrorRatios& a, const ErrorRatios& b) {
  return {std::max(a.along_u, b.along_u), std::max(a.along_v, b.along_v),
          std::max(a.centre, b.centre)};
}

/// Requests the samples of a leaf that are not known from the cell tree.
void request_samples(Leaf& leaf, CellTree& tree);

/// The tolerance in the ball around a leaf's corners.
double tolerance_of(const Leaf& leaf, const Tolerance& tolerance, const CellTree& tree);

/// The width of a leaf with these corners across its longest side; of a parallelogram, its smaller
/// height. Not finite where a corner is not.
double thickness(const Mesh& mesh, const std::array<std::uint32_t, 4>& corner);

/// The number of a leaf's nine samples that are defined.
int count_defined(const CellTree& tree, const Leaf& leaf);

/// Estimates the errors of leaves whose samples are known.
class ErrorIndicator {
 public:
  ErrorIndicator(const CellLimits& limits, const Grid& grid, const CellTree& tree);

  /// The tolerance in the ball around a leaf's nine samples.
  double allowed(const Leaf& leaf) const;
  /// Whether a side is on a drawn line or the domain's end. Its distance then counts in any
  /// direction.
  bool is_seen(const Leaf& leaf, std::size_t side) const;

  /// The errors of a leaf whose nine samples are all defined.
  CellError estimate(const Leaf& leaf) const;

  /// The error ratios of angles that are given by the squares of their tangents.
  ErrorRatios turn_ratios(const ErrorRatios& squares) const;

  /// Whether the pieces of surface around a leaf, between its features, are no longer than the
  /// tolerance on the mean of its sides. A part of a sheet that is missing there is not visible.
  bool is_too_small_to_see(const Leaf& leaf) const;

  /// Whether to halve a leaf along u that misses a counterexample: where the surface bends more
  /// along u there, unless the leaf is short along u already and its sides along v are off.
  bool splits_u(const Leaf& leaf, const Counterexample& counterexample) const;

  /// Whether to halve a leaf that failed along u.
  bool splits_u(const Leaf& leaf, const ErrorRatios& ratios) const;

  /// Whether to halve a leaf on the boundary along u: along the direction with more changes between
  /// defined and undefined samples. In a tie, and in a slender leaf, along the longer direction.
  bool splits_boundary_u(const Leaf& leaf) const;

  /// Whether all defined samples of a leaf are beyond one face of the clip box.
  bool is_clipped(const Leaf& leaf) const;

  /// Whether each defined sample is beyond some face of the clip box. Nothing is left of such a
  /// leaf if a pole goes through it.
  bool is_outside(const Leaf& leaf) const;

 private:
  dvec3 seen_position(std::uint32_t vertex) const;
  using Corners = std::array<std::uint32_t, 4>;
  struct ChordSample;

  /// At most as many as a leaf has samples.
  struct Positions {
    std::array<dvec3, 9> all;
    std::size_t count = 0;
    std::span<const dvec3> span() const { return std::span(all).first(count); }
  };
  Positions defined_positions(const SampleVertices& samples) const;
  double diameter(const Corners& corner) const;
  struct SideSample;
  SideSample side(const Leaf& leaf, std::size_t k) const;
  bool is_regular(std::uint32_t vertex) const;
  bool has_opposed(const SampleVertices& samples) const;
  /// `vertices`: the chord's ends and the sample.
  double distance_of_sample(const ChordSample& arc, const std::array<std::uint32_t, 3>& vertices,
                            bool border) const;
  std::size_t first_of_diagonal(const Corners& corner) const;
  double distance_from_triangles(const Leaf& leaf, std::size_t first,
                                 const ChordSample& diagonal) const;
  double bulge_of_triangles(const SampleVertices& samples, std::size_t first) const;
  double square_of_tangent(std::uint32_t a, std::uint32_t b, std::uint32_t sample) const;
  double turn_ratio(double square_of_tangent) const;

  const CellLimits& limits_;
  const Grid& grid_;
  std::optional<Bounds> far_;  ///< the clip box and a margin; positions are clamped to it
  const Mesh& mesh_;
  const CellTree& tree_;
};

}  // namespace saddle
