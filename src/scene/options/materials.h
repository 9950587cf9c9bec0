// The material of a side in scene files: by the one list of its parts in materials.cpp it is read,
// written and resolved.
#pragma once

#include <string>

#include "scene/model/resolver.h"
#include "scene/model/scene.h"
#include "scene/toml/toml_reader.h"

namespace saddle {

/// From a table of its parts, or its diffuse colour alone. `name` is what messages call the side.
/// Throws Error (Input) with the place of an unknown key or a wrong type.
void read_material(TomlReader& reader, const std::string& name, const TomlValue& value,
                   Material& material);

/// An inline table of what differs from `standard`; empty if nothing does.
std::string write_material(const Material& material, const Material& standard);

/// Fills in the value of each number. Throws Error (Input) for one outside of its limits.
void resolve_material(Resolver& resolver, const std::string& name, Material& material);

}  // namespace saddle
