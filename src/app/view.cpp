// saddle without an output: the viewer.
#include "app/view.h"

#include <string>
#include <utility>

#include "app/build_scene.h"
#include "app/commands.h"
#include "app/outputs.h"
#include "base/error.h"
#include "meshing/tessellate.h"
#include "render/framing.h"
#include "view/viewer.h"

namespace saddle {
namespace {

/// Cells of a preview each way: a few thousand triangles, which take some milliseconds.
constexpr GridSize kPreview{60, 60};

constexpr const char* kWayOut = "saddle ... -o FILE.png draws without a display";

/// Throws Error (Input) for options that would do nothing.
void check_options(const CommandLine& line) {
  checked_outputs(line);
  if (line.renderer != Backend::Any) {
    throw Error(Status::Input, "the viewer draws with the OpenGL of its display",
                {"--renderer", "", {}}, "it is for outputs: -o FILE.png");
  }
  if (line.frame_range) {
    throw Error(Status::Input, "the viewer plays all frames", {"--frame-range", "", {}},
                "it is for outputs: -o frame-%04d.png");
  }
  if (line.strict) {
    throw Error(Status::Input, "the viewer shows warnings and goes on", {"--strict", "", {}},
                "it is for outputs, -o FILE.png, and for saddle check");
  }
}

SurfaceMesh mesh_for_viewer(const Scene& scene, std::size_t surface, Detail detail,
                            const CommandLine& line) {
  Scene asked = scene;
  if (detail == Detail::Preview && !asked.mesh.samples) asked.mesh.samples = kPreview;
  Tessellation result =
      tessellate(asked, asked.surfaces[surface], {.picture = true, .mesh = false}, line.threads);
  if (line.quiet) result.warnings.clear();
  return {std::move(result.mesh), std::move(result.report), std::move(result.warnings)};
}

/// The camera of an animation, where it fits itself, holds all of it. A scene with an error is left
/// as it is: the viewer will show that.
void frame_animation(Scene& scene, unsigned threads) {
  try {
    Timeline timeline(scene);
    Framing framing = frame_scene(timeline, threads);
    framing.box.reset();  // what is edited has other ones soon
    framing.colors.clear();
    framing.apply(scene);
  } catch (const Error&) {
  }
}

}  // namespace

ViewerSetup viewer_setup(const CommandLine& line) {
  check_options(line);
  ViewerSetup setup;
  setup.scene = build_scene(line);
  setup.frame = [threads = line.threads](Scene& scene) { frame_animation(scene, threads); };
  setup.tessellate = [line](const Scene& scene, std::size_t surface, Detail detail) {
    return mesh_for_viewer(scene, surface, detail, line);
  };
  setup.reload = [line] { return build_scene(line); };
  if (line.watch) {
    setup.watched = scene_file_of(line);
    if (setup.watched.empty()) {
      throw Error(Status::Input, "there is no scene file to watch", {"--watch", "", {}},
                  "-o FILE.toml writes one");
    }
  }
  setup.quiet = line.quiet;
  setup.verbose = line.verbose;
  return setup;
}

#ifdef SADDLE_WITHOUT_VIEWER
void run_view(const CommandLine& line) {
  viewer_setup(line);  // what is wrong with the scene comes first
  throw Error(Status::Machine, "this saddle was built without its viewer", {},
              std::string("build it with -DSADDLE_VIEWER=ON\n") + kWayOut);
}
#else
void run_view(const CommandLine& line) {
  ViewerSetup setup = viewer_setup(line);
  try {
    Viewer(std::move(setup)).run();
  } catch (const Error& error) {
    if (error.status() != Status::Machine) throw;
    throw with_hint_line(error, kWayOut);
  }
}
#endif

}  // namespace saddle
