// Vector loops of the error estimates, compiled once for each CPU level: over leaves and their nine
// samples, and over leaves and validation points. Each also reports for which items its result
// holds; for others the scalar code applies.
#pragma once

#include <array>
#include <cstddef>

#include "eval/kernels.h"

namespace saddle {

/// Leaves per round: their columns stay in the first or second-level cache.
inline constexpr std::size_t kLeafBlock = 128;

/// One cache line more than a block. Columns a power of two apart share a few sets of the
/// first-level cache, and writing leaf by leaf to 60 of them would evict the others.
using LeafNumbers = std::array<double, kLeafBlock + 8>;

/// One vertex of each leaf.
struct LeafVertices {
  LeafNumbers x, y, z;
  LeafNumbers n_x, n_y, n_z;  ///< unit normals; zero where there is none
};

/// Leaves and the nine samples of mesh/error/error_indicator.h. `side` k is between corners k and
/// k + 1.
struct LeafSamples {
  std::array<LeafVertices, 4> corner;
  std::array<LeafVertices, 4> side;
  LeafVertices centre;
  std::array<LeafNumbers, 4> counts;  ///< 1: a side is an edge of the mesh; 0: its halves are
  std::array<LeafNumbers, 4> seen;    ///< 1: its distance counts in any direction
  LeafNumbers seen_turn;              ///< turns of normals along shorter chords do not count
};

/// Errors along u, along v and at the centre, as in ErrorRatios of mesh/error/error_indicator.h.
struct LeafRatios {
  LeafNumbers along_u, along_v, centre;
};

struct LeafErrors {
  LeafRatios distance;           ///< in units of length
  LeafNumbers gap_at_centre;     ///< the distance from the diagonal alone
  LeafRatios square_of_tangent;  ///< of the angle between normals
  LeafNumbers is_plain;          ///< 1: the errors hold; 0: ErrorIndicator::estimate() applies
  /// More than 0: turns of normals count.
  LeafNumbers turn_counts_on_sides, turn_counts_at_centre;
};

/// Estimates the errors of leaves [0, count).
using EstimateLeaves = void (*)(const LeafSamples& leaves, std::size_t count, LeafErrors& errors);

/// Leaves of two triangles, corners 0, 1, 2 and 2, 3, 0, in local units, and a point of the surface
/// above each.
struct LeafPoints {
  std::array<LeafVertices, 4> corner;
  double scale;  ///< local units per unit of length
  double front;  ///< 1: normals are along r_u x r_v; -1: the other way
};
/// A point for each leaf: its place in the leaf, p from corner 0 to 1 and q from 1 to 2, and the
/// columns of tangent_outputs(). If p and q are NaN, the point is outside of triangle 2 3 0.
struct LeafPlaces {
  const double* p;
  const double* q;
  std::array<const double*, 9> surface;
};
struct LeafSampledErrors {
  LeafNumbers distance;   ///< the largest, in local units
  LeafNumbers predicted;  ///< the largest beside the points, by mesh/distance/newton_step.h
  LeafNumbers chord;      ///< between unit normals, exact and interpolated: its largest square
  LeafNumbers is_known;   ///< 1: the errors hold; 0: sampled_error() applies
};

/// Takes the largest of the errors so far and those at one point of each of the leaves [0, count).
using ValidateLeaves = void (*)(const LeafPoints& leaves, const LeafPlaces& places,
                                std::size_t count, LeafSampledErrors& errors);

/// The loops of a level; all give the same bits.
EstimateLeaves estimate_loop(CpuLevel level);
ValidateLeaves validate_loop(CpuLevel level);

}  // namespace saddle
