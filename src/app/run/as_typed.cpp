#include "app/run/as_typed.h"

#include <algorithm>
#include <optional>
#include <string>

#include "formula/definition.h"
#include "formula/syntax.h"

namespace saddle {
namespace {

/// "surface 1: color-range" is the key color-range.
std::string key_of(const std::string& subject) {
  const std::size_t colon = subject.rfind(": ");
  return colon == std::string::npos ? subject : subject.substr(colon + 2);
}

bool is_curve_or_point(const Segment& segment) {
  const auto& words = segment.arguments;
  return !words.empty() && (words[0] == "curve" || words[0] == "point");
}

/// The surface's own name for u or v under which a curve or point was given this text; empty: it
/// was given under the usual name.
std::string typed_parameter(const Place& place, const CommandLine& line) {
  std::string own;
  for (const Segment& segment : line.segments) {
    if (!is_curve_or_point(segment)) continue;
    for (const std::string& argument : segment.arguments) {
      if (!argument.ends_with("=" + place.text)) continue;
      const std::string name = argument.substr(0, argument.find('='));
      if (name == place.name) return "";
      if (!is_coordinate(name) && name != "s") own = name;
    }
  }
  return own;
}

/// The words that were typed for the value that messages call `place.name`.
std::string typed_name(const Place& place, const CommandLine& line) {
  if (place.name == "u" || place.name == "v") {
    const std::string own = typed_parameter(place, line);
    return own.empty() ? place.name : own;
  }
  const std::string key = key_of(place.name);
  const auto is_meant = [&](const GivenOption& given) {
    return given.option->name == key && given.text.find(place.text) != std::string::npos;
  };
  bool is_option = std::ranges::any_of(line.given, is_meant);
  for (const Segment& segment : line.segments) {
    is_option = is_option || std::ranges::any_of(segment.given, is_meant);
  }
  if (is_option) return "--" + key;
  return key == "t" ? key : place.name;  // of "animation: t"
}

/// The text stands in an object that has no name, whose formulas may use any definition.
bool is_in_formulas(const std::string& text, const CommandLine& line) {
  const auto assigns = [](const std::string& argument) {
    return argument.find('=') != std::string::npos;
  };
  return std::ranges::any_of(line.segments, [&](const Segment& segment) {
    const auto& words = segment.arguments;
    if (words.empty()) return false;
    const auto holds = [&](const std::string& argument) { return argument.ends_with("=" + text); };
    const auto sets = [&](const GivenOption& given) { return given.text == text; };
    return (std::ranges::any_of(words, holds) || std::ranges::any_of(segment.given, sets)) &&
           (is_curve_or_point(segment) || std::ranges::all_of(words, assigns));
  });
}

}  // namespace

Error as_typed(const Error& error, const CommandLine& line) {
  if (!error.place().where.empty()) return error;
  Place place = error.place();
  place.name = typed_name(place, line);
  Error renamed(error.status(), error.what(), place, error.hint_lines());
  const std::optional<std::string> name = undefined_name(error);
  if (!name || !is_in_formulas(place.text, line)) return renamed;
  return with_hint_line(renamed, *name + "=1 defines it");
}

}  // namespace saddle
