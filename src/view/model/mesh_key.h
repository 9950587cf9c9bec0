// All that the mesh of a surface depends on, as text: where it stays the same, so does the mesh.
#pragma once

#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// The text for a surface of a resolved scene, or for one that stands for a curve or a point.
/// Colours, lights and other surfaces are not in it, nor are definitions that the surface does not
/// use.
std::string mesh_key(const Scene& scene, const SurfaceSpec& spec);

}  // namespace saddle
