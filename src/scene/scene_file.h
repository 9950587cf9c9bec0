// Scenes as TOML text.
#pragma once

#include <string>

#include "scene/scene.h"

namespace saddle {

/// The scene as a TOML scene file; what has its default value is left out.
std::string write_scene(const Scene& scene);

}  // namespace saddle
