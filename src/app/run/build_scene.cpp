// Sorts the arguments into names and assignments, then lets the options change the scene.
#include "app/run/build_scene.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>

#include "app/run/combine_objects.h"
#include "base/error.h"
#include "export/formats/load_scene.h"
#include "formula/lexer.h"
#include "scene/model/assignments.h"
#include "scene/model/gallery.h"
#include "scene/model/theme.h"
#include "scene/options/resolve.h"
#include "scene/options/scene_limits.h"

namespace saddle {
namespace {

bool is_scene_file(const std::string& name) {
  std::error_code ignored;  // a name that cannot be looked up is no file
  return has_scene_extension(name) || std::filesystem::is_regular_file(name, ignored);
}

/// The word is no file, no surface of the gallery, and not the first one of its object.
Error unknown_object(const std::string& name) {
  if (name != "curve" && name != "point") return unknown_gallery_name(name);
  const std::string object = name == "curve" ? "curve u=s v='2*s' s=0:tau" : "point 1,2,3";
  return {Status::Input,
          "a " + name + " beside a surface stands after a '+'",
          {},
          "for example saddle torus + " + object + " -o both.png"};
}

/// The scene of the argument without a `=`.
Scene named_scene(const std::string& name, const std::optional<Theme>& theme) {
  if (name == "-") return load_standard_input(theme);
  if (is_scene_file(name)) return load_scene(name, theme);
  const GalleryEntry* const entry = find_gallery_entry(name);
  if (entry == nullptr && find_option(name) != nullptr) {
    throw Error(Status::Input, "no surface is called '" + name + "'", {},
                "did you mean --" + name + "? saddle list prints all names of surfaces");
  }
  if (entry == nullptr) throw unknown_object(name);
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

bool is_assignment(const std::string& argument) {
  return argument.find('=') != std::string::npos;
}

/// The segment stands before all objects and has none: it has no name, no formula of a coordinate
/// and no range but that of t.
bool is_common(const Segment& segment) {
  return std::ranges::all_of(segment.arguments, [](const std::string& argument) {
    if (!is_assignment(argument)) return false;
    return !is_of_surface(parse_definition(argument));
  });
}

[[noreturn]] void refuse_second_name(const std::string& first, const std::string& second) {
  for (const std::string& name : {first, second}) {
    if (name != "-" && !is_scene_file(name) && find_gallery_entry(name) == nullptr) {
      throw unknown_object(name);
    }
  }
  throw Error(Status::Input, "two scenes, '" + first + "' and '" + second + "'", {},
              "put a + between them: " + first + " + " + second);
}

/// Puts the assignments where they belong. `alone`: the object is the whole scene.
void take_assignments(SceneObject& object, const std::vector<std::string>& assignments,
                      bool alone) {
  const bool has_formulas = object.from == SceneObject::From::Formulas;
  std::vector<std::string> own;
  for (const std::string& assignment : assignments) {
    const Definition definition = parse_definition(assignment);
    const bool is_shared =
        has_formulas ? !is_of_surface(definition) : !has_name(object.scene, definition.name);
    if (!alone && (is_shared || definition.name == "t")) {
      object.shared.push_back(assignment);
    } else {
      own.push_back(assignment);
    }
  }
  if (has_formulas) return assign_all(object.scene, own);
  for (const std::string& assignment : own) override_assignment(object.scene, assignment);
}

/// The definition, under the usual name if it is of a surface's parameter: `theta=2*s` on a sphere
/// of theta and phi is `u=2*s`. A coordinate, s and t keep their meaning in curves and points.
Definition on_surface(Definition definition, const ParameterNames& parameters) {
  const std::string& name = definition.name;
  const bool is_of_stroke = is_coordinate(name) || name == "s" || name == "t";
  if (definition.is_function || is_of_stroke) return definition;
  const auto found = std::ranges::find(parameters, name);
  if (found != parameters.end()) {
    definition.name = kUsualParameters[static_cast<std::size_t>(found - parameters.begin())];
  }
  return definition;
}

/// The words after `curve` or `point`, which may be on a surface with these `parameters`.
template <typename Stroke>
void read_stroke(const Segment& segment, const ParameterNames& parameters, Stroke stroke,
                 std::vector<Stroke>& strokes, SceneObject& object, bool alone) {
  constexpr bool kIsPoint = std::is_same_v<Stroke, PointSpec>;
  const std::string& word = segment.arguments[0];
  std::vector<std::string> assignments;
  for (std::size_t i = 1; i < segment.arguments.size(); ++i) {
    const std::string& argument = segment.arguments[i];
    if (is_assignment(argument)) {
      assignments.push_back(argument);
      const Definition given = parse_definition(argument);
      // A range is a mistake, and keeps the name that was typed.
      const bool is_own = assign(stroke, is_range(given) ? given : on_surface(given, parameters));
      if (!is_own && alone) assign(object.scene, argument);
      if (!is_own && !alone) object.shared.push_back(argument);
      continue;
    }
    if constexpr (kIsPoint) {
      if (!stroke.at) {
        set_place(argument, stroke);
        continue;
      }
    }
    throw Error(Status::Input, "'" + argument + "' is no part of a " + word, {},
                kIsPoint ? "for example point 1,2,3 or point u=1 v=2"
                         : "for example curve x='cos(s)' y='sin(s)' z='s/5' s=0:tau");
  }
  check_given_once(assignments);
  strokes.push_back(std::move(stroke));
}

/// The names of the parameters of the last surface of these objects.
ParameterNames last_parameters(std::span<const SceneObject> objects) {
  for (auto object = objects.rbegin(); object != objects.rend(); ++object) {
    if (!object->scene.surfaces.empty()) return object->scene.surfaces.back().parameters;
  }
  return kUsualParameters;
}

/// An option of the segment that says nothing of a curve or point.
void check_stroke_options(const Segment& segment) {
  for (const auto& [option, text] : segment.given) {
    if (option->stroke != nullptr) continue;
    throw Error(Status::Input, "a " + segment.arguments[0] + " takes no such option",
                {dashed(*option), "", {}},
                "it takes --color, --line-width, --radius, --label and --name");
  }
}

/// The object of a segment that begins with `curve` or `point`, after the objects `before` it.
SceneObject read_stroke_object(const Segment& segment, const Segment* common, bool alone,
                               std::span<const SceneObject> before) {
  SceneObject object;
  check_stroke_options(segment);
  const ParameterNames parameters = last_parameters(before);
  if (segment.arguments[0] == "curve") {
    read_stroke(segment, parameters, CurveSpec(), object.scene.curves, object, alone);
  } else {
    read_stroke(segment, parameters, PointSpec(), object.scene.points, object, alone);
  }
  if (common != nullptr) {
    std::ranges::copy_if(common->given, std::back_inserter(object.options),
                         [](const GivenOption& g) { return is_of_strokes(*g.option, true); });
  }
  std::ranges::copy(segment.given, std::back_inserter(object.options));
  return object;
}

bool is_stroke(const Segment& segment) {
  return !segment.arguments.empty() &&
         (segment.arguments[0] == "curve" || segment.arguments[0] == "point");
}

/// `common`: the segment that holds for all objects, or nullptr; `alone`: there is one object;
/// `before`: the objects before it.
SceneObject read_object(const Segment& segment, const Segment* common, bool alone,
                        const std::optional<Theme>& theme, std::span<const SceneObject> before) {
  if (is_stroke(segment)) return read_stroke_object(segment, common, alone, before);
  std::vector<std::string> names;
  std::vector<std::string> assignments;
  for (const std::string& argument : segment.arguments) {
    (is_assignment(argument) ? assignments : names).push_back(argument);
  }
  if (names.size() > 1) refuse_second_name(names[0], names[1]);
  check_given_once(assignments);
  SceneObject object;
  if (!names.empty()) {
    object.from = is_scene_file(names[0]) || names[0] == "-" ? SceneObject::From::File
                                                             : SceneObject::From::Gallery;
    object.scene = named_scene(names[0], theme);
  }
  if (common != nullptr) {
    for (const std::string& assignment : common->arguments) {
      const std::string name = assigned_name(assignment);
      const bool is_own = !names.empty() && name != "t" && has_name(object.scene, name);
      if (is_own) override_assignment(object.scene, assignment);
    }
    object.options = common->given;
  }
  take_assignments(object, assignments, alone);
  const bool is_empty =
      object.scene.surfaces.empty() && object.scene.curves.empty() && object.scene.points.empty();
  if (is_empty) object.scene.surfaces.emplace_back();
  object.options.insert(object.options.end(), segment.given.begin(), segment.given.end());
  return object;
}

bool has_strokes(const SceneObject& object) {
  return !object.scene.curves.empty() || !object.scene.points.empty();
}

/// An option that is of curves and points alone, in a segment that holds for none. `stroked`: it
/// holds for some.
void check_surface_options(const Segment& segment, bool stroked) {
  for (const auto& [option, text] : segment.given) {
    if (stroked || option->stroke == nullptr || option->surface || option->scene) continue;
    const std::string name = dashed(*option);
    throw Error(Status::Input, "there is no curve or point that takes it", {name, "", {}},
                "it stands behind one: + point 0,0,1 " + name + " " + text);
  }
}

}  // namespace

Scene build_scene(const CommandLine& line) {
  if (line.arguments().empty()) {
    throw Error(Status::Input, "no surface given", {},
                {"for example saddle z='sin(u)*cos(v)' u=-3:3 v=-3:3 -o waves.png",
                 "saddle --help says more"});
  }
  const std::vector<Segment>& segments = line.segments;
  const bool alone = segments.size() == 1;
  const Segment* const common = !alone && is_common(segments[0]) ? segments.data() : nullptr;
  const std::optional<Theme> theme = theme_of(line);
  std::vector<SceneObject> objects;
  for (const Segment& segment : segments) {
    if (&segment == common) continue;
    objects.push_back(read_object(segment, common, alone, theme, objects));
    check_surface_options(segment, has_strokes(objects.back()));
  }
  if (common != nullptr) check_surface_options(*common, std::ranges::any_of(objects, has_strokes));
  const std::vector<std::string> shared =
      common == nullptr ? std::vector<std::string>() : common->arguments;
  check_given_once(shared);
  Scene scene = combine_objects(objects, shared, line.given);
  if (theme) change_theme(scene, *theme);
  for (const auto& [option, text] : line.given) {
    if (option->name != "theme") apply_option(*option, text, scene);
  }
  apply_object_options(objects, scene);
  check_counts(scene);
  scene = resolve(std::move(scene));
  // A lone object was checked where its file was read, or its formulas have bounds of their own.
  if (objects.size() > 1) {
    check_formulas(scene, [](const std::string&, const std::function<void()>& bind) { bind(); });
  }
  return scene;
}

std::string scene_file_of(const CommandLine& line) {
  for (const std::string& argument : line.arguments()) {
    if (!is_assignment(argument) && is_scene_file(argument)) return argument;
  }
  return "";
}

}  // namespace saddle
