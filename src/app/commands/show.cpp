// saddle show NAME: a surface of the gallery as a scene file; with --shader the GLSL of a scene.
#include <algorithm>

#include "app/commands/commands.h"
#include "app/run/build_scene.h"
#include "app/run/picture_drawer.h"
#include "app/run/scene_meshes.h"
#include "base/error.h"
#include "base/standard_streams.h"
#include "render/picture/framing.h"
#include "scene/model/prepare.h"
#include "scene/model/strokes.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

/// The shaders of a program, each after what it is for, as comments of GLSL.
std::string program_text(const SurfaceProgram& program, const std::string& number) {
  std::string text = "// Program " + number + ": " + joined(program.surfaces) + "\n// Left out:\n";
  for (const std::string& part : program.left_out) text += "//   " + part + "\n";
  return text + "\n// Vertex shader\n" + program.text.vertex + "\n// Fragment shader\n" +
         program.text.fragment;
}

/// Draws the scene, and prints the programs that its surfaces were drawn with: they depend on
/// meshes and camera, too.
void show_shaders(const CommandLine& line) {
  const unsigned threads = static_cast<unsigned>(line.run.threads);
  Timeline timeline(build_scene(line));
  Scene scene = with_strokes(timeline.at(timeline.scene().t));
  const Framing framing = frame_scene(timeline, threads);
  framing.apply(scene);
  SceneMeshes meshes({.picture = true, .moments = framing.moments}, threads);
  const std::vector<std::size_t> updated = meshes.update(scene);
  PictureDrawer drawer(line.run.renderer);
  drawer.draw(scene, meshes.meshes(), updated);
  const std::vector<SurfaceProgram>& programs = drawer.programs();
  if (programs.empty()) {
    throw Error(Status::Nothing, "no surface is drawn", {}, "lines and dots have fixed shaders");
  }
  std::string text;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    const std::string number = std::to_string(i + 1) + " of " + std::to_string(programs.size());
    text += (i > 0 ? "\n" : "") + program_text(programs[i], number);
  }
  print(text);
}

}  // namespace

void run_show(const CommandLine& line) {
  const auto is_name = [](const std::string& s) { return s.find('=') == std::string::npos; };
  if (line.run.shader) return show_shaders(line);
  if (std::ranges::none_of(line.arguments(), is_name)) {
    throw Error(Status::Input, "saddle show needs the name of a surface", {},
                "saddle list prints the names; for example saddle show torus");
  }
  const Scene scene = build_scene(line);
  for (const SurfaceSpec& spec : scene.surfaces) prepare_surface(scene, spec);  // it must be right
  print(write_scene(scene));
}

}  // namespace saddle
