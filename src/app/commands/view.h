// The viewer's setup from the command line.
#pragma once

#include "app/command_line/cli.h"
#include "view/model/model.h"

namespace saddle {

/// The scene, where to read it anew, and options. Throws Error as
/// build_scene() does, and (Input) for options that the viewer would ignore.
ViewerSetup viewer_setup(const CommandLine& line);

}  // namespace saddle
