// [[light]] of scene files: lights.cpp has a table of its keys, by which lights are read, checked,
// written and resolved.
#pragma once

#include <string>
#include <vector>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/toml/toml_reader.h"

namespace saddle {

/// The light that a table describes. Its numbers are noted with `prefix` before their names. Throws
/// Error (Input) with the place of an unknown key, a wrong type, or keys that exclude each other.
Light read_light(TomlReader& reader, const std::string& prefix, const TomlValue& table);

/// A [[light]] for each; nothing for the default lights.
std::string write_lights(const std::vector<Light>& lights);

/// Fills in the value of each number. Throws Error (Input) for one outside of its limits.
void resolve_light(Resolver& resolver, const std::string& prefix, Light& light);

/// The keys of [[light]] and of its table `spot`, in the order in which they are written.
std::vector<std::string> light_keys();
std::vector<std::string> spot_keys();

}  // namespace saddle
