// saddle without an output: the viewer.
#include "app/commands/view.h"

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "app/commands/commands.h"
#include "app/run/build_scene.h"
#include "app/run/outputs.h"
#include "base/error.h"
#include "view/window/viewer.h"

namespace saddle {
namespace {

constexpr const char* kWayOut = "saddle ... -o FILE.png draws without a display";

/// Throws Error (Input) for options that would do nothing.
void check_options(const CommandLine& line) {
  checked_outputs(line);
  if (line.run.max_time) {
    throw Error(Status::Input, "the viewer takes as long as it is open", {"--max-time", "", {}},
                "it is for outputs: -o FILE.png");
  }
  if (line.run.renderer != Backend::Any) {
    throw Error(Status::Input, "the viewer draws with the OpenGL of its display",
                {"--renderer", "", {}}, "it is for outputs: -o FILE.png");
  }
  if (line.run.frame_range) {
    throw Error(Status::Input, "the viewer plays all frames", {"--frame-range", "", {}},
                "it is for outputs: -o frame-%04d.png");
  }
  if (line.run.strict) {
    throw Error(Status::Input, "the viewer shows warnings and goes on", {"--strict", "", {}},
                "it is for outputs, -o FILE.png, and for saddle check");
  }
}

}  // namespace

ViewerSetup viewer_setup(const CommandLine& line) {
  check_options(line);
  ViewerSetup setup;
  setup.scene = build_scene(line);
  setup.reload = [line] { return build_scene(line); };
  setup.file = scene_file_of(line);
  const std::vector<std::string> arguments = line.arguments();
  if (std::ranges::find(arguments, "-") != arguments.end()) {
    setup.reload = [scene = setup.scene] { return scene; };  // standard input is read once
  }
  if (line.run.watch) {
    setup.watched = setup.file;
    if (setup.watched.empty()) {
      throw Error(Status::Input, "there is no scene file to watch", {"--watch", "", {}},
                  "-o FILE.toml writes one");
    }
  }
  setup.threads = line.run.threads;
  setup.quiet = line.run.quiet;
  setup.verbose = line.run.verbose;
  return setup;
}

#ifdef SADDLE_WITHOUT_VIEWER
void run_view(const CommandLine& line) {
  viewer_setup(line);  // what is wrong with the scene comes first
  throw Error(Status::Machine, "this saddle was built without its viewer", {},
              {"build it with -DSADDLE_VIEWER=ON", kWayOut});
}
#else
namespace {

bool is_set(const char* variable) {
  const char* const value = std::getenv(variable);
  return value != nullptr && *value != 0;
}

/// There is nothing to show, but a display to choose on.
bool wants_start_page(const CommandLine& line) {
  const bool is_bare = line.arguments().empty() && line.given.empty() &&
                       line.segments.size() == 1 && line.segments[0].given.empty();
  return is_bare && (is_set("DISPLAY") || is_set("WAYLAND_DISPLAY"));
}

/// In a window that is large enough for some pictures of the gallery.
ViewerSetup start_setup() {
  ViewerSetup setup;
  setup.start = true;
  setup.scene.picture.width = 900;
  setup.scene.picture.height = 680;
  return setup;
}

}  // namespace

void run_view(const CommandLine& line) {
  const bool starts = wants_start_page(line);
  ViewerSetup setup = starts ? start_setup() : viewer_setup(line);
  try {
    Viewer(std::move(setup)).run();
  } catch (const Error& error) {
    if (starts) viewer_setup(line);  // without a window there is no surface to show, which it says
    if (error.status() != Status::Machine) throw;
    throw with_hint_line(error, kWayOut);
  }
}
#endif

}  // namespace saddle
