// Scenes from files of any format that carries one.
#pragma once

#include <filesystem>
#include <optional>

#include "scene/model/scene.h"

namespace saddle {

/// The extension is that of a format that carries a scene.
bool has_scene_extension(const std::filesystem::path& path);

/// read_scene() of a scene file, or of the scene inside a file of a format that carries one. A file
/// of any other name is read as a scene file. Throws Error (Input) also for a file that is missing
/// or holds no scene; Machine if it cannot be read. `theme`: in place of the file's.
Scene load_scene(const std::filesystem::path& path, const std::optional<Theme>& theme = {});

/// The same of what standard input holds: a scene file, or a file that carries one.
Scene load_standard_input(const std::optional<Theme>& theme = {});

}  // namespace saddle
