// Names are words of the scene's text. A word of another meaning there, such as a node's name, may
// hide a definition that is unused; none that is used is ever said to be unused.
#include "scene/options/unused_definitions.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

#include "formula/lexer.h"
#include "scene/options/options.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Words = std::set<std::string>;

/// The text in quotes, which has no keys.
std::string quoted_text(const std::string& toml) {
  std::string text;
  bool quoted = false;
  for (const char c : toml) {
    quoted = quoted != (c == '"');
    text += quoted ? c : ' ';
  }
  return text;
}

std::string text_of(const std::vector<Slider>& sliders) {
  std::string text;
  for (const Slider& slider : sliders) {
    text += slider.min.text + " " + slider.max.text + " " + slider.step.text + " ";
  }
  return text;
}

/// All but surfaces, definitions and titles.
std::string text_of_scene(const Scene& scene) {
  Scene rest = scene;
  rest.title.clear();
  rest.labels = {};
  rest.definitions.clear();
  rest.surfaces.clear();
  return quoted_text(write_scene(rest)) + text_of(scene.sliders);
}

Words words_of_surface(SurfaceSpec spec) {
  spec.name.clear();
  spec.texture = {};
  return names_in(quoted_text(write_keys(spec, Theme::Dark)) + text_of(spec.sliders));
}

/// Adds to a surface's words those that its own definitions use, and takes the names of these from
/// them. The names of its definitions that are not used.
std::vector<std::string> take_own(const SurfaceSpec& spec, Words& words) {
  std::vector<std::string> unused = take_used(spec.definitions, words);
  for (const Definition& own : spec.definitions) words.erase(own.name);
  return unused;
}

bool has_definitions(const Scene& scene) {
  const auto has_own = [](const SurfaceSpec& spec) { return !spec.definitions.empty(); };
  return !scene.definitions.empty() || std::ranges::any_of(scene.surfaces, has_own);
}

}  // namespace

std::vector<std::string> take_used(std::span<const Definition> definitions, Words& words) {
  std::multimap<std::string_view, const Definition*> left;
  for (const Definition& definition : definitions) left.emplace(definition.name, &definition);
  std::vector<std::string> fresh(words.begin(), words.end());
  while (!fresh.empty()) {
    const std::string word = std::move(fresh.back());
    fresh.pop_back();
    const auto [begin, end] = left.equal_range(word);
    for (auto used = begin; used != end; ++used) {
      Words names = names_in(used->second->text);
      for (const std::string& argument : used->second->arguments) names.erase(argument);
      for (const std::string& name : names) {
        if (words.insert(name).second) fresh.push_back(name);
      }
    }
    left.erase(begin, end);
  }
  std::vector<std::string> names;
  for (const Definition& definition : definitions) {
    if (left.contains(definition.name)) names.push_back(definition.name);
  }
  return names;
}

std::set<std::string> names_used_by(const SurfaceSpec& spec) {
  Words words = words_of_surface(spec);
  take_own(spec, words);
  return words;
}

std::vector<std::string> unused_definitions(const Scene& scene) {
  if (!has_definitions(scene)) return {};
  Words used = names_in(text_of_scene(scene));
  std::vector<std::string> unused;
  for (const SurfaceSpec& spec : scene.surfaces) {
    Words words = words_of_surface(spec);
    for (const std::string& name : take_own(spec, words)) {
      unused.push_back(spec.name + ": " + name);
    }
    used.merge(words);
  }
  const std::vector<std::string> shared = take_used(scene.definitions, used);
  unused.insert(unused.begin(), shared.begin(), shared.end());
  return unused;
}

}  // namespace saddle
