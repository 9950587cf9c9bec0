// Splits NAME=EXPRESSION and NAME(ARGUMENTS)=EXPRESSION and files the parts into a Scene. The
// expressions are not parsed here.
#include "scene/model/assignments.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
#include "formula/lexer.h"

namespace saddle {
namespace {

/// Names with a meaning of their own; they cannot be helper functions.
bool is_coordinate(const std::string& name) {
  return name == "x" || name == "y" || name == "z";
}
bool is_parameter(const std::string& name) {
  return name == "u" || name == "v" || name == "t";
}

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

/// The bytes of `span` without the spaces at its ends.
Span trim(std::string_view text, Span span) {
  while (span.begin < span.end && is_space(text[span.begin])) ++span.begin;
  while (span.begin < span.end && is_space(text[span.end - 1])) --span.end;
  return span;
}

std::string cut(std::string_view text, Span span) {
  return std::string(text.substr(span.begin, span.end - span.begin));
}

/// The name that `span` of the argument holds. Throws Error (Input) if it is not a name.
std::string checked_name(const std::string& assignment, Span span) {
  span = trim(assignment, span);
  std::string name = cut(assignment, span);
  if (is_name(name)) return meant_name(name);
  throw Error(Status::Input, name.empty() ? "the name is missing" : "'" + name + "' is not a name",
              {"argument", assignment, span},
              "an assignment is NAME=EXPRESSION; a name is made of letters, digits and _, and does "
              "not begin with a digit");
}

/// The names between the brackets of `f(s, t)`; `inside` spans what is between them.
std::vector<std::string> argument_names(const std::string& assignment, Span inside) {
  const Span trimmed = trim(assignment, inside);
  if (trimmed.begin == trimmed.end) {
    throw Error(Status::Input, "a helper function without arguments",
                {"argument", assignment, {inside.begin - 1, inside.end + 1}},
                "leave the brackets out: NAME=EXPRESSION");
  }
  std::vector<std::string> names;
  for (std::size_t begin = inside.begin; begin <= inside.end;) {
    const std::size_t comma = std::min(assignment.find(',', begin), inside.end);
    names.push_back(checked_name(assignment, {begin, comma}));
    begin = comma + 1;
  }
  return names;
}

[[noreturn]] void throw_bad_range(const Definition& definition, const std::string& message,
                                  Span span) {
  throw Error(Status::Input, message, {definition.name, definition.text, span},
              "for example " + definition.name + "=0:2*pi");
}

Range parse_range(const Definition& definition) {
  const std::string& text = definition.text;
  const std::size_t colon = range_colon(text).value_or(text.size());
  if (colon == text.size()) throw_bad_range(definition, "a range is MIN:MAX", {0, text.size()});
  if (const auto second = range_colon(text, colon + 1)) {
    throw_bad_range(definition, "a range has one ':'", {*second, *second + 1});
  }
  Range range{cut(text, trim(text, {0, colon})), cut(text, trim(text, {colon + 1, text.size()}))};
  if (range.min.empty())
    throw_bad_range(definition, "the lower end is missing", {colon, colon + 1});
  if (range.max.empty())
    throw_bad_range(definition, "the upper end is missing", {colon, colon + 1});
  return range;
}

/// `t=MIN:MAX` is the range of time, `t=VALUE` one moment.
void set_time(Scene& scene, const Definition& definition) {
  if (!range_colon(definition.text)) {
    scene.t = Number(definition.text);
    return;
  }
  const Range range = parse_range(definition);
  set_time_range(scene, Number(range.min), Number(range.max));
}

SurfaceSpec& last_surface(Scene& scene) {
  if (scene.surfaces.empty()) scene.surfaces.emplace_back();
  return scene.surfaces.back();
}

/// Ranges are for u, v and t. Another name gets its values by way of u or v.
void check_range_name(const Definition& definition) {
  const std::string& name = definition.name;
  if (definition.is_function || is_parameter(name) || !is_range(definition)) return;
  const std::string& ends = definition.text;
  std::string hint = "for example u=" + ends + " " + name + "=u, or v=" + ends + " " + name + "=v";
  if (name == "x") hint = "write u=" + ends + "; x is u unless it has a formula";
  if (name == "y") hint = "write v=" + ends + "; y is v unless it has a formula";
  throw Error(Status::Input, "only u, v and t have a range", {name, ends, {0, ends.size()}}, hint);
}

void file(Scene& scene, const Definition& definition) {
  check_range_name(definition);
  const std::string& name = definition.name;
  if (is_coordinate(name)) {
    SurfaceSpec& spec = last_surface(scene);
    (name == "x" ? spec.x : name == "y" ? spec.y : spec.z) = definition.text;
  } else if (name == "t") {
    set_time(scene, definition);
  } else if (is_parameter(name)) {
    SurfaceSpec& spec = last_surface(scene);
    (name == "u" ? spec.u : spec.v) = parse_range(definition);
  } else {
    const auto found = std::ranges::find(scene.definitions, name, &Definition::name);
    if (found == scene.definitions.end()) {
      scene.definitions.push_back(definition);
    } else {
      *found = definition;
    }
  }
}

}  // namespace

std::optional<std::size_t> range_colon(const std::string& text, std::size_t begin) {
  int depth = 0;
  int questions = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (depth != 0) continue;
    if (c == '?') ++questions;
    if (c == ':' && questions-- == 0) return i;
  }
  return std::nullopt;
}

bool is_range(const Definition& definition) {
  return range_colon(definition.text).has_value();
}

Definition parse_definition(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw Error(Status::Input, "no '=' in the assignment",
                {"argument", assignment, {0, assignment.size()}}, "for example r=0.4");
  }
  Definition result;
  const Span left = trim(assignment, {0, equals});
  const std::size_t bracket = std::min(assignment.find('(', left.begin), left.end);
  result.is_function = bracket < left.end && assignment[left.end - 1] == ')';
  if (result.is_function) {
    result.name = checked_name(assignment, {left.begin, bracket});
    result.arguments = argument_names(assignment, {bracket + 1, left.end - 1});
  } else {
    result.name = checked_name(assignment, left);
  }
  if (result.is_function && (is_coordinate(result.name) || is_parameter(result.name))) {
    throw Error(Status::Input, "'" + result.name + "' cannot be a helper function",
                {"argument", assignment, left}, "give the function another name");
  }
  result.text = cut(assignment, trim(assignment, {equals + 1, assignment.size()}));
  if (result.text.empty()) {
    throw Error(Status::Input, "the expression is empty", {result.name, "", {}},
                "for example " + result.name + (is_parameter(result.name) ? "=0:1" : "=u*v"));
  }
  return result;
}

void assign(Scene& scene, const std::string& assignment) {
  file(scene, parse_definition(assignment));
}

void override_assignment(Scene& scene, const std::string& assignment) {
  const Definition definition = parse_definition(assignment);
  std::vector<std::string> names;
  for (const Definition& known : scene.definitions) names.push_back(known.name);
  for (const char* name : {"x", "y", "z", "u", "v", "t"}) names.emplace_back(name);
  if (std::ranges::find(names, definition.name) == names.end()) {
    std::string hint = "known names:";
    for (const std::string& name : names) hint += " " + name;
    if (const auto nearest = nearest_name(definition.name, names)) {
      hint += "; did you mean '" + *nearest + "'?";
    }
    throw Error(Status::Input, scene.title + " has no '" + definition.name + "'",
                {"argument", assignment, trim(assignment, {0, assignment.find('=')})}, hint);
  }
  const std::string& name = definition.name;
  if (scene.surfaces.size() > 1 && (is_coordinate(name) || name == "u" || name == "v")) {
    throw Error(Status::Input, "each of the scene's surfaces has its own '" + name + "'",
                {"argument", assignment, trim(assignment, {0, assignment.find('=')})},
                "change a parameter, or the scene file");
  }
  file(scene, definition);
}

}  // namespace saddle
