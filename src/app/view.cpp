// saddle without an output: the viewer.
#include <utility>

#include "app/build_scene.h"
#include "app/commands.h"
#include "app/outputs.h"
#include "app/tessellate.h"
#include "base/error.h"
#include "view/viewer.h"

namespace saddle {
namespace {

/// Cells of a preview each way: a few thousand triangles, which take some milliseconds.
constexpr GridSize kPreview{60, 60};

SurfaceMesh mesh_for_viewer(const Scene& scene, std::size_t surface, Detail detail,
                            unsigned threads) {
  Scene asked = scene;
  if (detail == Detail::Preview && !asked.mesh.samples) asked.mesh.samples = kPreview;
  Tessellation result =
      tessellate(asked, asked.surfaces[surface], {.picture = true, .mesh = false}, threads);
  return {std::move(result.mesh), std::move(result.report.mesh), std::move(result.warnings)};
}

}  // namespace

void run_view(const CommandLine& line) {
  checked_outputs(line);  // for options that have no meaning without an output
  if (line.renderer != Backend::Any) {
    throw Error(Status::Input, "the viewer draws with the OpenGL of its display",
                {"--renderer", "", {}}, "it is for outputs: -o FILE.png");
  }
  ViewerSetup setup;
  setup.scene = build_scene(line);
  setup.tessellate = [threads = line.threads](const Scene& scene, std::size_t surface,
                                              Detail detail) {
    return mesh_for_viewer(scene, surface, detail, threads);
  };
  setup.reload = [line] { return build_scene(line); };
  if (line.watch) {
    setup.watched = scene_file_of(line);
    if (setup.watched.empty()) {
      throw Error(Status::Input, "there is no scene file to watch", {"--watch", "", {}},
                  "-o FILE.toml writes one");
    }
  }
  setup.verbose = line.verbose;
  run_viewer(std::move(setup));
}

}  // namespace saddle
