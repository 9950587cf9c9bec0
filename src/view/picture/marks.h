// Lines that a viewer draws beside the surfaces.
#pragma once

#include <glm/mat4x4.hpp>

#include "mesh/model/mesh.h"

namespace saddle {

/// Adds the normals of a mesh, where `to_world` puts it, as lines of `length`, at corners that are
/// about evenly spread over it, to a mesh that has only lines.
void append_normal_marks(const Mesh& mesh, const glm::dmat4& to_world, double length, Mesh& marks);

}  // namespace saddle
