// The errors that the report of an adaptive mesh tells.
#pragma once

#include "mesh/mesher/mesh_request.h"
#include "mesh/model/mesh_report.h"
#include "mesh/tree/leaf_mesh.h"
#include "surface/surface.h"

namespace saddle {

class AdaptiveMesher;

/// Sets max_error, worst_place and max_normal_error. `triangles`: of all leaves. Validation knows
/// distances of a leaf from its own triangles; if one exceeds the tolerance, the largest is
/// searched for anew, against the whole mesh.
void report_errors(const Surface& surface, const MeshRequest& request, const AdaptiveMesher& mesher,
                   const LeafTriangles& triangles, MeshReport& report);

}  // namespace saddle
