// The material of a solid's walls, which are neither its surface's front nor its back.
#pragma once

#include "scene/model/scene.h"

namespace saddle {

/// The mean of front and back, which is grey for yellow and blue. The surface is resolved.
Material wall_material(const SurfaceSpec& surface);

}  // namespace saddle
