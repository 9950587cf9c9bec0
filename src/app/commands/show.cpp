// saddle show NAME: a surface of the gallery as a scene file.
#include <algorithm>

#include "app/commands/commands.h"
#include "app/run/build_scene.h"
#include "base/error.h"
#include "base/standard_streams.h"
#include "scene/model/prepare.h"
#include "scene/toml/scene_file.h"

namespace saddle {

void run_show(const CommandLine& line) {
  const auto is_name = [](const std::string& s) { return s.find('=') == std::string::npos; };
  if (std::ranges::none_of(line.arguments(), is_name)) {
    throw Error(Status::Input, "saddle show needs the name of a surface", {},
                "saddle list prints the names; for example saddle show torus");
  }
  const Scene scene = build_scene(line);
  for (const SurfaceSpec& spec : scene.surfaces) prepare_surface(scene, spec);  // it must be right
  print(write_scene(scene));
}

}  // namespace saddle
