// Edge features where the surface goes to infinity: at poles, or where it leaves the clip box on
// its way to one.
#pragma once

#include <span>
#include <vector>

#include "base/bounds.h"
#include "mesh/mesher/trace_options.h"
#include "mesh/tree/edge_table.h"
#include "mesh/tree/vertex_geometry.h"

namespace saddle {

class CellTree;

/// Cuts sides that lead to poles: EdgeTable::leads_to_pole(). With a clip box, a side is cut where
/// the surface leaves the box on the way to the pole from either end. Without one, it is cut at the
/// last vertices on either side of the pole; they are no part of the mesh.
void cut_poles(std::span<const Side> sides, const TraceOptions& options, CellTree& tree);

/// Searches sides with a boundary, jump or crease for poles between it and the ends of the side. A
/// side keeps one edge feature: a pole replaces the other.
void find_poles_beside_cuts(std::span<const Side> sides, const TraceOptions& options,
                            CellTree& tree);

/// Whether the surface goes to infinity at each boundary.
std::vector<bool> diverge_at(std::span<const Between> boundaries, const TraceOptions& options,
                             const CellTree& tree);

/// Moves boundaries at which the surface goes to infinity to the faces of the clip box. Returns
/// which were moved; none without a clip box.
std::vector<bool> end_at_faces(const std::vector<bool>& goes_far, std::span<Between> boundaries,
                               const TraceOptions& options, CellTree& tree);

/// A box around the last places of the surface beside the poles on sides, and beyond faces of the
/// clip box.
Bounds box_beside_poles(const CellTree& tree, unsigned threads);

}  // namespace saddle
