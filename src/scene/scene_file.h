// Scenes as TOML text.
#pragma once

#include <filesystem>
#include <string>

#include "scene/scene.h"
#include "scene/toml.h"

namespace saddle {

/// The keyword of the PNG text chunk that holds a picture's scene.
inline constexpr const char* kSceneKeyword = "saddle-scene";

/// The scene as a TOML scene file; what has its default value is left out.
std::string write_scene(const Scene& scene);

/// The scene that a scene file holds, checked as a whole: formulas, numbers, nodes. Throws Error
/// (Input) with file, line and column: no TOML, an unknown key, a wrong type, or anything that
/// resolve() and bind_surface() find.
Scene read_scene(const SourceText& source);

/// read_scene() of a TOML file, or of the scene in a PNG. Throws Error (Input) also for a file that
/// is missing or a picture without a scene; Machine if it cannot be read.
Scene load_scene(const std::filesystem::path& path);

}  // namespace saddle
