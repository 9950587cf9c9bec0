// Options of searches for edge features.
#pragma once

#include <cstddef>
#include <optional>

#include "base/bounds.h"
#include "mesh/model/tolerance.h"

namespace saddle {

/// Sides that are searched together, between two checks of the budget: some milliseconds if each
/// side takes hundreds of evaluations.
inline constexpr std::size_t kSidesAtATime = 512;

struct TraceOptions {
  Tolerance tolerance;
  /// Whether poles become edge features. A leaf is removed with its pole, so only small leaves may
  /// have one.
  bool poles = false;
  unsigned threads = 0;
  /// The mesh is clipped to this box: a surface that goes to infinity ends on a face of it.
  std::optional<Bounds> clip = {};
  /// The search ends once a mesh of so many triangles has spent its effort; 0: it does not.
  std::size_t max_triangles = 0;
};

}  // namespace saddle
