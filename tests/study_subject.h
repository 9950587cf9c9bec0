// Surfaces as a study sees them.
#pragma once

#include <string>

#include "study/subject.h"

namespace saddle {

/// A scene of one surface, of formulas and ranges as a user writes them.
inline Scene scene_of(const std::string& x, const std::string& y, const std::string& z,
                      const Range& u = {}, const Range& v = {}) {
  Scene scene;
  SurfaceSpec& spec = scene.surfaces.emplace_back();
  spec.x = x;
  spec.y = y;
  spec.z = z;
  spec.u = u;
  spec.v = v;
  return scene;
}

}  // namespace saddle
