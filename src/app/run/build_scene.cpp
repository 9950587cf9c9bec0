// Sorts the arguments into names and assignments, then lets the options change the scene.
#include "app/run/build_scene.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "base/error.h"
#include "export/load_scene.h"
#include "formula/lexer.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/model/theme.h"
#include "scene/options/resolve.h"

namespace saddle {
namespace {

bool is_scene_file(const std::string& name) {
  std::error_code ignored;  // a name that cannot be looked up is no file
  return has_scene_extension(name) || std::filesystem::is_regular_file(name, ignored);
}

/// The scene of the argument without a `=`.
Scene named_scene(const std::string& name, const std::optional<Theme>& theme) {
  if (name == "-") return load_standard_input(theme);
  if (is_scene_file(name)) return load_scene(name, theme);
  const GalleryEntry* const entry = find_gallery_entry(name);
  if (entry == nullptr) throw unknown_gallery_name(name);
  return gallery_scene(*entry);
}

/// The theme that the command line asks for. Its other options win, in whatever order they stand.
std::optional<Theme> theme_of(const CommandLine& line) {
  std::optional<Theme> theme;
  for (const auto& [option, text] : line.given) {
    if (option->name != "theme") continue;
    Scene scene;
    apply_option(*option, text, scene);
    theme = scene.theme;
  }
  return theme;
}

/// The name before the `=`, without arguments and spaces.
std::string assigned_name(const std::string& assignment) {
  std::string name = assignment.substr(0, assignment.find_first_of("=("));
  std::erase(name, ' ');
  return meant_name(name);
}

void check_given_once(const std::vector<std::string>& assignments) {
  std::vector<std::string> names;
  for (const std::string& assignment : assignments) {
    const std::string name = assigned_name(assignment);
    if (std::ranges::find(names, name) != names.end()) {
      throw Error(Status::Input, "'" + name + "' is given twice",
                  {"argument", assignment, {0, assignment.find_first_of("=(")}},
                  "leave one of them out");
    }
    names.push_back(name);
  }
}

/// A colormap without anything to colour would do nothing.
void check_colormap_is_used(const CommandLine& line, const Scene& scene) {
  const Option* const option = line.last_given({"colormap"});
  const auto has_no_color = [](const SurfaceSpec& spec) { return spec.color.empty(); };
  if (option == nullptr || !std::ranges::all_of(scene.surfaces, has_no_color)) return;
  throw Error(Status::Input, "there is nothing to colour", {dashed(*option), "", {}},
              "--color z colours by height, --color gauss by curvature");
}

}  // namespace

Scene build_scene(const CommandLine& line) {
  std::vector<std::string> names;
  std::vector<std::string> assignments;
  for (const std::string& argument : line.arguments) {
    (argument.find('=') == std::string::npos ? names : assignments).push_back(argument);
  }
  if (names.size() > 1) {
    throw Error(Status::Input, "two scenes, '" + names[0] + "' and '" + names[1] + "'", {},
                assignments.empty() ? "graph one at a time"
                                    : "a formula with spaces is written in quotes: z='u + v'");
  }
  if (line.arguments.empty()) {
    throw Error(Status::Input, "no surface given", {},
                {"for example saddle z='sin(u)*cos(v)' u=-3:3 v=-3:3 -o waves.png",
                 "saddle --help says more"});
  }
  check_given_once(assignments);
  const std::optional<Theme> theme = theme_of(line);
  Scene scene = names.empty() ? Scene{} : named_scene(names[0], theme);
  for (const std::string& assignment : assignments) {
    names.empty() ? assign(scene, assignment) : override_assignment(scene, assignment);
  }
  if (scene.surfaces.empty()) scene.surfaces.emplace_back();
  if (theme) change_theme(scene, *theme);
  for (const auto& [option, text] : line.given) {
    if (option->name != "theme") apply_option(*option, text, scene);
  }
  check_colormap_is_used(line, scene);
  return resolve(std::move(scene));
}

std::string scene_file_of(const CommandLine& line) {
  const auto is_file = [](const std::string& argument) {
    return argument.find('=') == std::string::npos && is_scene_file(argument);
  };
  const auto found = std::ranges::find_if(line.arguments, is_file);
  return found == line.arguments.end() ? "" : *found;
}

}  // namespace saddle
