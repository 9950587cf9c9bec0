// From the command line to the Scene it asks for.
#pragma once

#include <string>

#include "app/command_line/cli.h"
#include "scene/model/scene.h"

namespace saddle {

/// The scene file, gallery surface or formulas of the command line, with its assignments and
/// options applied, resolved at its moment. Throws Error (Input): no surface or two, an unknown
/// name, a malformed assignment, anything wrong with a scene file or a number.
Scene build_scene(const CommandLine& line);

/// The scene file that the command line names; empty if there is none.
std::string scene_file_of(const CommandLine& line);

}  // namespace saddle
