// The surfaces of a scene as solids: all together, as millimetres of a print depend on its size.
#pragma once

#include <span>

#include "meshing/tessellate.h"
#include "scene/model/scene.h"

namespace saddle {

/// Makes solids of the meshes of surfaces with a thickness: made[i] is that of scene.surfaces[i],
/// or null where there is none; `scene` is resolved. `measured`: with reports, findings and
/// warnings. `threads` 0: all. Throws Error (Input): one side of a one-sided surface; a thickness
/// that no print of its size can have, or that is lost in the rounding of positions.
void thicken_scene(const Scene& scene, std::span<Tessellation* const> made, bool measured,
                   unsigned threads);

}  // namespace saddle
