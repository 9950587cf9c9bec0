// Options of searches for edge features.
#pragma once

#include <cstddef>
#include <optional>

#include "base/bounds.h"
#include "mesh/model/tolerance.h"
#include "mesh/tree/triangle_budget.h"

namespace saddle {

struct TraceOptions {
  Tolerance tolerance;
  /// Whether sides that lead to poles are cut without a clip box, too. A leaf is removed with its
  /// pole, so this waits until leaves are small.
  bool poles = false;
  unsigned threads = 0;
  /// The mesh is clipped to this box: a surface that goes to infinity ends on a face of it.
  std::optional<Bounds> clip = {};
  /// The search ends once the effort of this limit is spent.
  TriangleLimit triangles = {};
};

}  // namespace saddle
