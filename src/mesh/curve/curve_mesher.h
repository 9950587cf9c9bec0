// The chords of a curve: within a tolerance, cut where the curve is undefined, jumps or has a pole.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "base/bounds.h"
#include "mesh/curve/curve.h"
#include "mesh/model/tolerance.h"

namespace saddle {

struct CurveRequest {
  /// The largest distance between the curve and its chords.
  Tolerance tolerance = 1;
  double radius = 0;  ///< of the tube round the curve, which keeps the tolerance too; 0: a line
  /// The curve is cut along this box.
  std::optional<Bounds> clip = {};
  std::size_t max_points = 50'000;  ///< refinement stops there
};

/// Neighbouring points of a curve that chords join.
using CurveChain = std::vector<CurvePoint>;

struct CurveMesh {
  std::vector<CurveChain> chains;  ///< in the order of s, from the start of the range
  bool closed = false;             ///< one chain that ends where it begins
  Bounds bounds;                   ///< of the chains' points
  double length = 0;               ///< of the chords
  std::size_t evaluations = 0;     ///< points at which the curve was computed
  double tolerance = 0;            ///< the least that was asked for anywhere on it
  double max_error = 0;            ///< largest distance from a sample to its chord
  double undefined_fraction = 0;   ///< share of the range of s
  double proved_fraction = 0;      ///< share where interval bounds prove the tolerance
  std::vector<double> jumps;       ///< ascending s
  std::vector<double> poles;       ///< ascending s
  bool reached_limit = false;      ///< max_points ended refinement
};

/// Chords are halved until samples between their ends are within the tolerance, gaps down to the
/// last double. Interval bounds of the derivative then look for what the samples missed: a
/// continuous curve whose slope stays in [m, M] over a length h of s is within (M - m) h / 4 of its
/// chord. Source: R. Moore, "Interval analysis", 1966.
CurveMesh mesh_curve(const ParametricCurve& curve, const CurveRequest& request);

}  // namespace saddle
