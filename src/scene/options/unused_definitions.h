// Definitions of a scene that change nothing.
#pragma once

#include <set>
#include <span>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

/// The names of the definitions that no formula or number of the scene uses, be it through others;
/// of a surface's own ones with the surface's name, "torus: r".
std::vector<std::string> unused_definitions(const Scene& scene);

/// Adds to the names those that their definitions use, and theirs. The names of the definitions
/// that are not used.
std::vector<std::string> take_used(std::span<const Definition> definitions,
                                   std::set<std::string>& names);

/// The names that the formulas and numbers of a surface use, without its own definitions.
std::set<std::string> names_used_by(const SurfaceSpec& spec);

}  // namespace saddle
