// The plan of a mesh, made before any cell: its tolerance and the lines of its root grid.
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

struct MeshPlan {
  Probe probe;
  Tolerance tolerance;
  /// 0.98 of the tolerance: samples miss part of the largest distance. Coarser by a factor if the
  /// limit of triangles is less than any mesh needs.
  Tolerance aim;
  LineCounts line_counts;  ///< of the drawn lines
  FixedLines drawn;        ///< the drawn lines and the ends of the ranges
  SingularSet singular;    ///< singular points and lines; root lines pass through them, if few
  FixedLines fixed;        ///< lines that the root grid must have: fixed_lines()
  FixedLines lines;        ///< of the root grid
  SizingField sizing;      ///< for which the lines were placed
  double coarser = 1;      ///< that factor
};

/// Empty if the surface is so large or small that its tolerance is not a positive number, or if it
/// needs more lines than can be numbered.
std::optional<MeshPlan> plan_mesh(const Surface& surface, const MeshRequest& request);

/// A tolerance that is infinite outside of the clip box.
Tolerance tolerance_within(const std::optional<Bounds>& clip, const Tolerance& tolerance);

/// A report with the tolerance and the limits of the plan.
MeshReport report_of(const MeshPlan& plan);

}  // namespace saddle
