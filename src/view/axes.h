// The box around the surfaces with ticks on three of its edges.
#pragma once

#include <string>
#include <vector>

#include "mesh/mesh.h"

namespace saddle {

/// Text beside a tick, or the name of an axis.
struct AxisLabel {
  dvec3 place;
  std::string text;
};

/// Round numbers in [low, high], about `count` of them: 1, 2 or 5 times a power of ten apart.
std::vector<double> ticks(double low, double high, int count);

/// Adds the edges of a box and its ticks to a mesh that has only lines. Returns what is to be
/// written beside them.
std::vector<AxisLabel> append_axes(const Bounds& box, Mesh& marks);

}  // namespace saddle
