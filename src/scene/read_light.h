// The table of a light in a scene file.
#pragma once

#include <string>

#include "scene/scene.h"
#include "scene/toml_reader.h"

namespace saddle {

/// Its numbers are noted with `prefix` before their names. Throws Error (Input) with the place of
/// what is wrong.
Light read_light(TomlReader& reader, const std::string& prefix, const TomlValue& table);

}  // namespace saddle
