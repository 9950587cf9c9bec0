#include "scene/options/command_text.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "scene/model/assignments.h"
#include "scene/model/values.h"
#include "scene/options/options.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

/// In single quotes, unless no shell makes anything of its characters.
std::string quoted(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-+=:.,/%@").find(c) != std::string_view::npos;
  };
  if (!text.empty() && std::ranges::all_of(text, is_plain)) return text;
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// The scene that the command's assignments make. Title, name and sliders change nothing about the
/// picture.
Scene assigned(const std::vector<std::string>& assignments, const Scene& scene) {
  Scene result;
  assign_all(result, assignments);
  result.surfaces.resize(1);
  result.surfaces[0].name = scene.surfaces[0].name;
  result.title = scene.title;
  result.sliders = scene.sliders;
  return result;
}

/// The assignments and options make this very scene, but for the rounding of their texts.
bool make_the_scene(const std::vector<std::string>& assignments,
                    const std::vector<Setting>& settings, const Scene& scene) {
  Scene rounded = scene;
  try {
    Scene made = assigned(assignments, scene);
    for (const auto& [option, text] : settings) {
      apply_option(*option, text, made);
      if (!option->is_flag()) apply_option(*option, text, rounded);
    }
    return write_scene(made) == write_scene(rounded);
  } catch (const Error&) {
    return false;  // an expression or a name that only a scene file can have
  }
}

std::vector<std::string> assignments(const Scene& scene) {
  const SurfaceSpec& spec = scene.surfaces[0];
  std::vector<std::string> result;
  const auto add = [&](const std::string& name, const std::string& text) {
    result.push_back(name + "=" + text);
  };
  if (spec.x != SurfaceSpec{}.x) add("x", spec.x);
  if (spec.y != SurfaceSpec{}.y) add("y", spec.y);
  if (!spec.z.empty()) add("z", spec.z);
  if (!spec.xyz.empty()) add("xyz", spec.xyz);
  if (!spec.where.empty()) add("where", spec.where);
  const bool has_usual_names = spec.parameters == kUsualParameters;
  for (const auto& [name, ends] :
       {std::pair{spec.parameters[0], spec.u}, std::pair{spec.parameters[1], spec.v}}) {
    const bool is_usual = ends.min == Range{}.min && ends.max == Range{}.max;
    if (!is_usual || !has_usual_names) add(name, ends.min + ":" + ends.max);
  }
  for (const Definition& d : scene.definitions) add(display_name(d), d.text);
  if (const auto& a = scene.animation) {
    add("t", expression_of(a->from) + ":" + expression_of(a->to));
  }
  return result;
}

}  // namespace

std::optional<std::string> command_text(const Scene& scene) {
  if (scene.surfaces.size() != 1) return std::nullopt;
  const std::vector<Setting> settings = settings_of(scene);
  const std::vector<std::string> assigned = assignments(scene);
  if (!make_the_scene(assigned, settings, scene)) return std::nullopt;
  std::string command = "saddle";
  for (const std::string& assignment : assigned) command += " " + quoted(assignment);
  for (const auto& [option, text] : settings) {
    command += " " + dashed(*option);
    if (!option->is_flag()) command += " " + quoted(text);
  }
  return command;
}

}  // namespace saddle
