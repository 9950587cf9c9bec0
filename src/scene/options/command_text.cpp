#include "scene/options/command_text.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/error.h"
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

/// The scene that the command's assignments make. Title and sliders change nothing about the
/// picture.
Scene assigned(const Scene& scene) {
  Scene result;
  const SurfaceSpec& spec = scene.surfaces[0];
  SurfaceSpec& plain = result.surfaces.emplace_back();
  plain.name = spec.name;
  plain.x = spec.x;
  plain.y = spec.y;
  plain.z = spec.z;
  plain.u = spec.u;
  plain.v = spec.v;
  result.definitions = scene.definitions;
  if (scene.animation) set_time_range(result, scene.animation->from, scene.animation->to);
  result.title = scene.title;
  result.sliders = scene.sliders;
  return result;
}

/// The assignments and options make this very scene, but for the rounding of their texts.
bool make_the_scene(const std::vector<Setting>& settings, const Scene& scene) {
  Scene made = assigned(scene);
  Scene rounded = scene;
  try {
    for (const auto& [option, text] : settings) {
      apply_option(*option, text, made);
      if (!option->is_flag()) apply_option(*option, text, rounded);
    }
  } catch (const Error&) {
    return false;  // an expression that only a scene file can have
  }
  return write_scene(made) == write_scene(rounded);
}

std::vector<std::pair<std::string, std::string>> assignments(const Scene& scene) {
  const SurfaceSpec& spec = scene.surfaces[0];
  std::vector<std::pair<std::string, std::string>> result;
  if (spec.x != SurfaceSpec{}.x) result.emplace_back("x", spec.x);
  if (spec.y != SurfaceSpec{}.y) result.emplace_back("y", spec.y);
  result.emplace_back("z", spec.z);
  for (const auto& [name, ends] : {std::pair{"u", spec.u}, std::pair{"v", spec.v}}) {
    if (ends.min != Range{}.min || ends.max != Range{}.max) {
      result.emplace_back(name, ends.min + ":" + ends.max);
    }
  }
  for (const Definition& d : scene.definitions) result.emplace_back(display_name(d), d.text);
  if (const auto& a = scene.animation) {
    result.emplace_back("t", expression_of(a->from) + ":" + expression_of(a->to));
  }
  return result;
}

}  // namespace

std::optional<std::string> command_text(const Scene& scene) {
  if (scene.surfaces.size() != 1) return std::nullopt;
  const std::vector<Setting> settings = settings_of(scene);
  if (!make_the_scene(settings, scene)) return std::nullopt;
  std::string command = "saddle";
  for (const auto& [name, value] : assignments(scene)) {
    command += " " + quoted(name + "=" + value);
  }
  for (const auto& [option, text] : settings) {
    command += " " + dashed(*option);
    if (!option->is_flag()) command += " " + quoted(text);
  }
  return command;
}

}  // namespace saddle
