// Scenes as TOML text.
#pragma once

#include <optional>
#include <string>

#include "scene/model/scene.h"
#include "scene/toml/toml.h"

namespace saddle {

/// The scene as a TOML scene file; what has its default value is left out.
std::string write_scene(const Scene& scene);

/// The scene that a scene file holds, checked as a whole: formulas, numbers, nodes. Throws Error
/// (Input) with file, line and column: no TOML, an unknown key, a wrong type, or anything that
/// resolve() and bind_surface() find. `theme`: in place of the file's.
Scene read_scene(const SourceText& source, const std::optional<Theme>& theme = {});

/// The same of a scene that is not finished: formulas, numbers and nodes may be wrong.
Scene read_draft(const SourceText& source);

}  // namespace saddle
