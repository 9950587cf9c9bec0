// What halving does not help is cut out of a mesh: points and lines at which the surface goes to
// infinity, and points at which it has no limit.
#pragma once

#include <optional>
#include <vector>

#include "mesh/crossings.h"
#include "mesh/measured.h"
#include "mesh/refine.h"

namespace saddle {

/// A point at which the surface is not defined, or jumps.
struct PlacedHole {
  dvec2 uv;
  Hole hole;
};

/// Whether nothing of a leaf is within a box, if there is one.
bool is_clipped(const Leaf& leaf, const std::optional<Bounds>& clip, const Lattice& lattice);

/// Leaves out those leaves in which the surface goes to infinity at a point, or has no limit there.
/// Returns these points, each of them once.
std::vector<PlacedHole> leave_out_holes(const Surface& surface, const RefineOptions& options,
                                        const Lattice& lattice, Measured& mesh);

/// Cuts the sides of leaves that halving did not help where they are known to lead to poles, which
/// would be walls; and, if `search`, where they are found to.
void cut_walls(const RefineOptions& options, bool search, Lattice& lattice, Measured& mesh);

}  // namespace saddle
