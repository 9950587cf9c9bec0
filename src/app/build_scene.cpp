// Sorts the arguments into names and assignments, then lets the options change the scene.
#include "app/build_scene.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "scene/assignments.h"
#include "scene/gallery.h"
#include "scene/prepare.h"

namespace saddle {
namespace {

bool is_scene_file(const std::string& name) {
  std::error_code ignored;  // a name that cannot be looked up is no file
  return name.ends_with(".toml") || name.ends_with(".png") ||
         std::filesystem::is_regular_file(name, ignored);
}

/// The scene of the argument without a `=`.
Scene named_scene(const std::string& name) {
  if (is_scene_file(name)) {
    throw Error(Status::Input, "scene files cannot be read yet: " + name, {},
                "graph formulas, or a surface of the gallery (saddle list)");
  }
  const GalleryEntry* const entry = find_gallery_entry(name);
  if (entry == nullptr) throw unknown_gallery_name(name);
  return gallery_scene(*entry);
}

/// The name before the `=`, without arguments and spaces.
std::string assigned_name(const std::string& assignment) {
  std::string name = assignment.substr(0, assignment.find_first_of("=("));
  std::erase(name, ' ');
  return name;
}

void check_given_once(const std::vector<std::string>& assignments) {
  std::vector<std::string> names;
  for (const std::string& assignment : assignments) {
    const std::string name = assigned_name(assignment);
    if (std::ranges::find(names, name) != names.end()) {
      throw Error(Status::Input, "'" + name + "' is given twice",
                  {"argument", assignment, {0, name.size()}}, "leave one of them out");
    }
    names.push_back(name);
  }
}

void apply_options(const CommandLine& line, Scene& scene) {
  Camera& camera = scene.camera;
  if (line.view) camera.view = *line.view;
  if (line.up) camera.up = *line.up;
  if (line.target) camera.target = line.target;
  if (line.distance) camera.distance = line.distance;
  if (line.fov) camera.fov = *line.fov;
  if (line.ortho) camera.ortho = true;
  if (line.clip) scene.clip = *line.clip;
  if (line.background) scene.background = *line.background;
  if (line.t) scene.t = finite_constant(scene, "--t", *line.t);
  for (SurfaceSpec& spec : scene.surfaces) {
    if (line.front) spec.front.diffuse = *line.front;
    if (line.back) spec.back.diffuse = *line.back;
    if (line.flip) spec.flip = !spec.flip;
    if (line.grid) spec.grid_u = line.grid->u;
    if (line.grid) spec.grid_v = line.grid->v;
  }
}

}  // namespace

Scene build_scene(const CommandLine& line) {
  std::vector<std::string> names;
  std::vector<std::string> assignments;
  for (const std::string& argument : line.arguments) {
    (argument.find('=') == std::string::npos ? names : assignments).push_back(argument);
  }
  if (names.size() > 1) {
    throw Error(Status::Input, "two surfaces, '" + names[0] + "' and '" + names[1] + "'", {},
                "graph one at a time");
  }
  if (line.arguments.empty()) {
    throw Error(Status::Input, "no surface given", {},
                "for example saddle z='sin(u)*cos(v)' u=-3:3 v=-3:3 -o waves.png\n"
                "saddle --help says more");
  }
  check_given_once(assignments);
  std::stable_partition(assignments.begin(), assignments.end(),
                        [](const std::string& text) { return !assigns_time(text); });
  Scene scene = names.empty() ? Scene{} : named_scene(names[0]);
  for (const std::string& assignment : assignments) {
    names.empty() ? assign(scene, assignment) : override_assignment(scene, assignment);
  }
  if (scene.surfaces.empty()) scene.surfaces.emplace_back();
  apply_options(line, scene);
  return scene;
}

}  // namespace saddle
