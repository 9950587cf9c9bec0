// Names are words of the scene's text. A word of another meaning there, such as a node's name, may
// hide a definition that is unused; none that is used is ever said to be unused.
#include "scene/options/unused_definitions.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "formula/lexer.h"
#include "scene/toml/scene_file.h"

namespace saddle {
namespace {

using Words = std::set<std::string>;

/// The names in a text, as formulas mean them.
Words words_of(std::string_view text) {
  Words words;
  while (!text.empty()) {
    const std::size_t length = name_length(text);
    if (length > 0) words.insert(meant_name(text.substr(0, length)));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return words;
}

/// The text of all but definitions, titles and keys: what stands in quotes.
std::string text_without_definitions(const Scene& scene) {
  Scene rest = scene;
  rest.title.clear();
  rest.labels = {};
  rest.definitions.clear();
  for (SurfaceSpec& surface : rest.surfaces) surface.name.clear();
  std::string text;
  bool quoted = false;
  for (const char c : write_scene(rest)) {
    quoted = quoted != (c == '"');
    text += quoted ? c : ' ';
  }
  for (const Slider& slider : scene.sliders) text += slider.min.text + " " + slider.max.text + " ";
  return text;
}

}  // namespace

std::vector<std::string> unused_definitions(const Scene& scene) {
  Words used = words_of(text_without_definitions(scene));
  std::vector<const Definition*> left;
  for (const Definition& definition : scene.definitions) left.push_back(&definition);
  const auto take_used = [&](const Definition* definition) {
    if (!used.contains(definition->name)) return false;
    Words words = words_of(definition->text);
    for (const std::string& argument : definition->arguments) words.erase(argument);
    used.merge(words);
    return true;
  };
  while (std::erase_if(left, take_used) > 0) {
  }
  std::vector<std::string> names;
  for (const Definition* definition : left) names.push_back(definition->name);
  return names;
}

}  // namespace saddle
