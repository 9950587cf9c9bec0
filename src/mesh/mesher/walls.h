// Walls between sheets that a clip box cuts: where a jump crosses a pole's line, the surface leaps
// from beyond one face of the box into it, or to beyond the opposite one. Triangles must not
// follow.
#pragma once

#include "base/bounds.h"
#include "mesh/error/validated_mesh.h"
#include "surface/surface.h"

namespace saddle {

/// Removes the triangles of small leaves that cross a face of the box where the surface leaps: on
/// the line from the lowest corner to the highest, the surface is nowhere about half way up.
/// `vertices`: of the triangles, with their parameters.
void remove_walls(const Surface& surface, const Bounds& clip, const Mesh& vertices,
                  unsigned threads, ValidatedMesh& mesh);

}  // namespace saddle
