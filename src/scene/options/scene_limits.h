// Bounds of what a scene may hold, whether it comes from a file or from the command line.
#pragma once

#include <functional>
#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// Throws Error (Input), without a place, for too many objects, grid lines or definitions.
void check_counts(const Scene& scene);

/// Calls an action that binds the formulas of one object; `prefix` is what messages call the
/// object, as "surface 1: ".
using BindObject =
    std::function<void(const std::string& prefix, const std::function<void()>& action)>;

/// Binds the formulas of each object of a resolved scene. Throws Error (Input) for the first that
/// is wrong, or where all formulas together are too long.
void check_formulas(const Scene& resolved, const BindObject& bind);

}  // namespace saddle
