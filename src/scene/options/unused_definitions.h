// Definitions of a scene that change nothing.
#pragma once

#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// The names of the definitions that no formula or number of the scene uses, be it through others.
std::vector<std::string> unused_definitions(const Scene& scene);

}  // namespace saddle
