// From the command line to the Scene it asks for.
#pragma once

#include "app/cli.h"
#include "scene/scene.h"

namespace saddle {

/// The gallery surface or the formulas of the command line, with its options applied. Throws Error
/// (Input): no surface or two, an unknown name, a malformed assignment.
Scene build_scene(const CommandLine& line);

}  // namespace saddle
