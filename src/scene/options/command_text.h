// A scene as the command that graphs it.
#pragma once

#include <optional>
#include <string>

#include "scene/model/scene.h"

namespace saddle {

/// `saddle x=... --view ...`, quoted for a shell. Nothing for what only a scene file can say:
/// several surfaces, nodes, lights of its own.
std::optional<std::string> command_text(const Scene& scene);

}  // namespace saddle
