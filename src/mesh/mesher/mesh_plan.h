// What is decided of a mesh before any cell is made: its tolerance, and the lines of its root grid.
#pragma once

#include <optional>

#include "mesh/features/singular.h"
#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "mesh/model/tolerance.h"
#include "mesh/sizing/place_lines.h"
#include "mesh/sizing/probe.h"
#include "mesh/sizing/second_form.h"
#include "surface/surface.h"

namespace saddle {

/// What is known of a mesh before it is made.
struct MeshPlan {
  Probe probe;
  Tolerance tolerance;
  Tolerance aim;            ///< a little less: samples miss some of the largest distance
  FixedLines drawn;         ///< lines that are drawn, and the ends of the ranges
  SingularSet singular;     ///< where a root line goes, if they are few
  FixedLines fixed;         ///< lines that the root grid must have: fixed_lines()
  FixedLines lines;         ///< of the root grid
  SizingField sizing;       ///< that they were placed for
  bool is_limited = false;  ///< they are farther apart than the tolerance asks for: max_triangles
};

/// Nothing if the surface is so large or small that its tolerance is not a positive number, or
/// takes more lines than can be numbered.
std::optional<MeshPlan> plan_mesh(const Surface& surface, const MeshRequest& request);

/// A tolerance that is infinite outside of the clip box.
Tolerance tolerance_within(const std::optional<Bounds>& clip, const Tolerance& tolerance);

/// The tolerance as a share of the surface's diagonal.
double share_of_diagonal(const MeshPlan& plan);

/// What a report says of a mesh before it is made.
MeshReport report_of(const MeshPlan& plan);

}  // namespace saddle
