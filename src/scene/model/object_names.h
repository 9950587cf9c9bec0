// Names that tell the objects of a scene apart.
#pragma once

#include "scene/model/scene.h"

namespace saddle {

/// Puts a number after each name of a surface, curve or point that an earlier one has: `torus`,
/// `torus 2`.
void number_names(Scene& scene);

}  // namespace saddle
