// A surface of a scene with its mesh and what is true of it: for `saddle check`.
#pragma once

#include "meshing/tessellate.h"
#include "scene/model/scene.h"
#include "study/facts.h"

namespace saddle {

/// Both in the user's parameters.
struct CheckedSurface {
  Tessellation tessellation;
  Facts facts;
};

/// Checks surface `spec` of `scene`, meshed as for a file. Throws Error as tessellate() does.
CheckedSurface check_surface(const Scene& scene, const SurfaceSpec& spec, unsigned threads);

}  // namespace saddle
