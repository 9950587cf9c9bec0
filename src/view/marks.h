// Lines that a viewer draws beside the surfaces.
#pragma once

#include "mesh/mesh.h"

namespace saddle {

/// Adds the normals as lines of `length`, at corners that are about evenly spread over the mesh, to
/// a mesh that has only lines.
void append_normal_marks(const Mesh& mesh, double length, Mesh& marks);

}  // namespace saddle
