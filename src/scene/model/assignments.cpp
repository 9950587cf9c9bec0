// Splits NAME=EXPRESSION and NAME(ARGUMENTS)=EXPRESSION and files the parts into a Scene. The
// expressions are not parsed here.
#include "scene/model/assignments.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cctype>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/nearest.h"
#include "formula/language.h"
#include "formula/lexer.h"
#include "scene/model/choices.h"

namespace saddle {
namespace {

/// Names with a meaning of their own; they cannot be helper functions.
bool is_usual_parameter(const std::string& name) {
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

/// The parameter of the surface that has this name, 0 or 1.
std::optional<std::size_t> parameter_of(const SurfaceSpec& spec, const std::string& name) {
  const auto found = std::ranges::find(spec.parameters, name);
  if (found == spec.parameters.end()) return std::nullopt;
  return static_cast<std::size_t>(found - spec.parameters.begin());
}

/// A range of what is no parameter of the surface.
Error not_a_parameter(const Definition& definition, const SurfaceSpec& spec, bool is_constant) {
  const auto& [u, v] = spec.parameters;
  const std::string& name = definition.name;
  const std::string ends = definition.text.substr(*range_colon(definition.text) + 1);
  const Place place{name, definition.text, {0, definition.text.size()}};
  const std::string parameters = "the parameters of " + spec.name + " are " + u + " and " + v;
  if (is_constant) {
    return {Status::Input, "'" + name + "' is a constant of " + spec.name + ", which has no range",
            place, "write " + name + "=" + ends + "; " + parameters};
  }
  return {Status::Input, "'" + name + "' is not a parameter of " + spec.name, place,
          parameters + ": " + u + "=" + definition.text};
}

/// The formula or condition of the surface that has this name.
std::string& formula_of(SurfaceSpec& spec, const std::string& name) {
  return name == "x"     ? spec.x
         : name == "y"   ? spec.y
         : name == "z"   ? spec.z
         : name == "xyz" ? spec.xyz
                         : spec.where;
}

void define(Scene& scene, const Definition& definition) {
  check_names(definition);
  const auto found = std::ranges::find(scene.definitions, definition.name, &Definition::name);
  if (found == scene.definitions.end()) {
    scene.definitions.push_back(definition);
  } else {
    *found = definition;
  }
}

void file(Scene& scene, const Definition& definition) {
  const std::string& name = definition.name;
  const bool has_surface = !scene.surfaces.empty();
  const auto parameter = parameter_of(has_surface ? scene.surfaces.back() : SurfaceSpec(), name);
  if (!definition.is_function && name != "t" && (parameter || is_range(definition))) {
    SurfaceSpec& spec = last_surface(scene);
    if (!parameter) {
      const auto known = std::ranges::find(scene.definitions, name, &Definition::name);
      throw not_a_parameter(definition, spec, known != scene.definitions.end());
    }
    (*parameter == 0 ? spec.u : spec.v) = parse_range(definition);
  } else if (is_coordinate(name) || name == "where") {
    formula_of(last_surface(scene), name) = definition.text;
  } else if (name == "t") {
    set_time(scene, definition);
  } else {
    define(scene, definition);
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

bool is_of_surface(const Definition& definition) {
  const std::string& name = definition.name;
  return name != "t" && (is_coordinate(name) || is_usual_parameter(name) || name == "where" ||
                         is_range(definition));
}

Definition parse_definition(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  assert(equals != std::string::npos);
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
  if (result.is_function &&
      (is_coordinate(result.name) || is_usual_parameter(result.name) || result.name == "where")) {
    throw Error(Status::Input, "'" + result.name + "' cannot be a helper function",
                {"argument", assignment, left}, "give the function another name");
  }
  result.text = cut(assignment, trim(assignment, {equals + 1, assignment.size()}));
  if (result.text.empty()) {
    throw Error(Status::Input, "the expression is empty", {result.name, "", {}},
                "for example " + result.name + (is_usual_parameter(result.name) ? "=0:1" : "=u*v"));
  }
  return result;
}

std::string fault_of_parameter(const std::string& name) {
  if (!is_name(name)) return "'" + name + "' is not a name";
  if (name == "where") return "'where' is the condition of a surface";
  if (name == "t") return "t is the time, not a parameter of a surface";
  if (name == "xyz") return "'xyz' is the position of a surface";
  const BuiltIn* const function = find_built_in(name);
  if (function != nullptr && !can_be_hidden(*function))
    return "'" + name + "' is a function of the language";
  return "";
}

void assign(Scene& scene, const std::string& assignment) {
  file(scene, parse_definition(assignment));
}

bool assign(CurveSpec& curve, const Definition& definition) {
  const std::string& name = definition.name;
  if (definition.is_function || name == "t") return false;
  if (name == "s") {
    curve.s = parse_range(definition);
    return true;
  }
  if (is_range(definition)) {
    throw Error(Status::Input, "a curve has a range of s, and of t, but none of " + name,
                {name, definition.text, {0, definition.text.size()}}, "write s=" + definition.text);
  }
  const auto own = std::to_array<std::pair<const char*, std::string*>>({{"x", &curve.x},
                                                                        {"y", &curve.y},
                                                                        {"z", &curve.z},
                                                                        {"xyz", &curve.xyz},
                                                                        {"u", &curve.u},
                                                                        {"v", &curve.v}});
  const auto found = std::ranges::find(own, name, &std::pair<const char*, std::string*>::first);
  if (found == own.end()) return false;
  *found->second = definition.text;
  return true;
}

bool assign(PointSpec& point, const Definition& definition) {
  const std::string& name = definition.name;
  if (definition.is_function || name == "t") return false;
  const Place place{name, definition.text, {0, definition.text.size()}};
  if (is_range(definition)) {
    throw Error(Status::Input, "a point has no ranges", place, "for example point u=1 v=2");
  }
  if (is_coordinate(name)) {
    throw Error(Status::Input, "the place of a point is one word", place,
                "for example point 1,2,3");
  }
  if (name != "u" && name != "v") return false;
  (name == "u" ? point.u : point.v) = definition.text;
  return true;
}

namespace {

[[noreturn]] void refuse_third(const std::vector<Definition>& ranges) {
  std::string names = ranges[0].name;
  for (std::size_t i = 1; i < ranges.size(); ++i) {
    names += (i + 1 < ranges.size() ? ", " : " and ") + ranges[i].name;
  }
  const Definition& third = ranges[2];
  throw Error(Status::Input, "a surface has two parameters, and these are more: " + names,
              {third.name, third.text, {0, third.text.size()}}, "leave one of the ranges out");
}

/// The names of the two parameters by the ranges that are given.
ParameterNames parameters_of(const std::vector<Definition>& ranges) {
  std::array<std::optional<std::string>, 2> places;
  const auto take = [&](std::size_t place, const std::string& name) {
    const bool is_free = !places[place];
    if (is_free) places[place] = name;
    return is_free;
  };
  std::vector<std::string> left(ranges.size());
  std::ranges::transform(ranges, left.begin(), &Definition::name);
  for (const auto& usual : {std::pair{"u", "v"}, std::pair{"x", "y"}}) {
    std::erase_if(left, [&](const std::string& name) {
      return (name == usual.first && take(0, name)) || (name == usual.second && take(1, name));
    });
  }
  for (const std::string& name : left) take(places[0] ? 1 : 0, name);
  return {places[0].value_or("u"), places[1].value_or("v")};
}

}  // namespace

void assign_all(Scene& scene, const std::vector<std::string>& assignments) {
  std::vector<Definition> all(assignments.size());
  std::ranges::transform(assignments, all.begin(), parse_definition);
  std::vector<Definition> ranges;
  for (const Definition& definition : all) {
    const bool is_of_time = definition.name == "t";
    if (definition.is_function || is_of_time || !is_range(definition)) continue;
    ranges.push_back(definition);
    const std::string fault = fault_of_parameter(definition.name);
    if (fault.empty()) continue;
    throw Error(Status::Input, fault,
                {definition.name, definition.text, {0, definition.text.size()}},
                "choose another name");
  }
  if (ranges.size() > 2) refuse_third(ranges);
  if (!ranges.empty()) last_surface(scene).parameters = parameters_of(ranges);
  for (const Definition& definition : all) file(scene, definition);
}

namespace {

std::vector<std::string> names_of(const Scene& scene) {
  std::vector<std::string> names;
  for (const Definition& known : scene.definitions) names.push_back(known.name);
  const bool is_one = scene.surfaces.size() == 1;
  const ParameterNames parameters = is_one ? scene.surfaces[0].parameters : kUsualParameters;
  for (const char* name : {"x", "y", "z"}) {
    if (std::ranges::find(parameters, name) == parameters.end()) names.emplace_back(name);
  }
  names.insert(names.end(), parameters.begin(), parameters.end());
  names.insert(names.end(), {"t", "where", "xyz"});
  return names;
}

Span name_span(const std::string& assignment) {
  return trim(assignment, {0, assignment.find('=')});
}

}  // namespace

bool has_name(const Scene& scene, const std::string& name) {
  const std::vector<std::string> names = names_of(scene);
  return std::ranges::find(names, name) != names.end();
}

Error unknown_override(const Scene& scene, const std::string& assignment) {
  const std::string wrong = parse_definition(assignment).name;
  const Place place{"argument", assignment, name_span(assignment)};
  // Scenes without a title of their own have the program's name.
  const std::string subject = scene.title == Scene().title ? "the scene" : scene.title;
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (std::ranges::find(spec.definitions, wrong, &Definition::name) == spec.definitions.end())
      continue;
    return {Status::Input, subject + " has no '" + wrong + "' of its own", place,
            "surface '" + spec.name + "' has one, which its file alone changes: params = { " +
                wrong + " = ... }"};
  }
  const std::vector<std::string> names = names_of(scene);
  std::string hint = "known names:";
  for (const std::string& known : names) hint += " " + known;
  if (const auto nearest = nearest_name(wrong, names)) hint += "; did you mean '" + *nearest + "'?";
  return {Status::Input, subject + " has no '" + wrong + "'", place, hint};
}

void override_assignment(Scene& scene, const std::string& assignment) {
  Definition definition = parse_definition(assignment);
  const std::string& name = definition.name;
  if (!has_name(scene, name)) throw unknown_override(scene, assignment);
  take_choice(scene.sliders, scene.definitions, definition);
  if (scene.surfaces.size() > 1 && is_of_surface(definition)) {
    throw Error(Status::Input, "each of the scene's surfaces has its own '" + name + "'",
                {"argument", assignment, name_span(assignment)},
                "change a parameter, or the scene file");
  }
  file(scene, definition);
}

}  // namespace saddle
