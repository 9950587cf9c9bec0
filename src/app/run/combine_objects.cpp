#include "app/run/combine_objects.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <optional>
#include <set>
#include <span>
#include <type_traits>
#include <utility>

#include "base/error.h"
#include "base/format.h"
#include "formula/language.h"
#include "formula/lexer.h"
#include "scene/model/assignments.h"
#include "scene/model/color.h"
#include "scene/model/object_names.h"
#include "scene/options/unused_definitions.h"

namespace saddle {
namespace {

using From = SceneObject::From;

/// A definition that all formulas of the command line share.
struct Shared {
  std::string assignment;
  Definition definition;
  std::optional<Error> unless_used = {};  ///< what is wrong if nothing uses it
  bool is_optional = false;               ///< it may be unused: objects have taken it
};

bool is_same(const Definition& a, const Definition& b) {
  return a.text == b.text && a.arguments == b.arguments && a.is_function == b.is_function;
}

/// The shared definitions and the time, each name once.
class Pool {
 public:
  void add(Shared added) {
    const auto known = std::ranges::find(shared_, added.definition.name, name_of);
    if (known == shared_.end()) {
      shared_.push_back(std::move(added));
    } else if (!is_same(known->definition, added.definition)) {
      throw Error(Status::Input,
                  "two definitions of '" + added.definition.name + "': " + known->assignment +
                      " and " + added.assignment,
                  {"argument", added.assignment, {0, added.assignment.find('=')}},
                  added.definition.name == "t"
                      ? "a scene has one time: leave one of them out"
                      : "objects share their definitions: give one of them another name");
    } else if (!added.unless_used) {
      known->unless_used.reset();
    }
  }

  void set_time(Scene& scene) {
    for (const Shared& shared : shared_) {
      if (shared.definition.name == "t") assign(scene, shared.assignment);
    }
    std::erase_if(shared_, [](const Shared& s) { return s.definition.name == "t"; });
  }

  std::vector<Definition> definitions() const {
    std::vector<Definition> result;
    for (const Shared& shared : shared_) result.push_back(shared.definition);
    return result;
  }

  /// Throws Error (Input) for one that only an object without that name could have meant. Removes
  /// those that objects have taken.
  void settle(const std::vector<std::string>& unused, std::vector<Definition>& definitions) const {
    for (const Shared& shared : shared_) {
      const std::string& name = shared.definition.name;
      if (std::ranges::find(unused, name) == unused.end()) continue;
      if (shared.unless_used) throw Error(*shared.unless_used);
      if (shared.is_optional)
        std::erase_if(definitions, [&](const auto& d) { return d.name == name; });
    }
  }

 private:
  static const std::string& name_of(const Shared& shared) { return shared.definition.name; }

  std::vector<Shared> shared_;
};

/// `name` as a word of a formula becomes `other`.
std::string renamed(const std::string& text, const std::string& name, const std::string& other) {
  std::string result;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = std::max<std::size_t>(name_length(text.substr(i)), 1);
    const std::string word = text.substr(i, length);
    result += meant_name(word) == name ? other : word;
    i += length;
  }
  return result;
}

/// Gives a name that a surface's own definition hides another one in the scene's.
void rename(std::vector<Definition>& definitions, const std::string& name) {
  std::string other = name + "_";
  const auto is_taken = [&](const Definition& d) { return d.name == other; };
  while (std::ranges::any_of(definitions, is_taken)) other += "_";
  for (Definition& d : definitions) {
    if (d.name == name) d.name = other;
    if (std::ranges::find(d.arguments, name) == d.arguments.end()) {
      d.text = renamed(d.text, name, other);
    }
  }
}

/// The scene's definitions that a surface uses become its own, and mean the same in its formulas.
/// `names`: those that its options use.
void keep_definitions(const Scene& scene, std::set<std::string> names, SurfaceSpec& spec) {
  std::vector<Definition> definitions = scene.definitions;
  names.merge(names_used_by(spec));
  const std::vector<std::string> unused = take_used(definitions, names);
  if (scene.surfaces.size() > 1) {
    std::erase_if(definitions, [&](const Definition& d) {
      return std::ranges::find(unused, d.name) != unused.end();
    });
  }
  for (const Definition& own : spec.definitions) {
    if (std::ranges::find(definitions, own.name, &Definition::name) != definitions.end()) {
      rename(definitions, own.name);
    }
  }
  spec.definitions.insert(spec.definitions.begin(), definitions.begin(), definitions.end());
  spec.sliders.insert(spec.sliders.end(), scene.sliders.begin(), scene.sliders.end());
}

/// The text of a constant that a shared definition hides.
std::string constant_text(const std::complex<double>& constant) {
  if (constant.imag() != 0) return std::string(kImaginaryUnit);
  const double value = constant.real();
  return std::isnan(value) ? "0/0" : std::isinf(value) ? "1/0" : format_number(value);
}

/// Constants of the language keep their meaning in formulas that are not the command line's.
void keep_constants(const std::vector<Definition>& shared, SurfaceSpec& spec) {
  std::set<std::string> names = names_used_by(spec);
  for (const Definition& own : spec.definitions) names.merge(names_in(own.text));
  for (const Definition& definition : shared) {
    const auto value = find_constant(definition.name);
    const bool is_own = std::ranges::find(spec.definitions, definition.name, &Definition::name) !=
                        spec.definitions.end();
    if (!value || is_own || !names.contains(definition.name)) continue;
    spec.definitions.push_back({definition.name, constant_text(*value)});
  }
}

/// The definitions of a scene file and the shared ones can stand side by side.
bool are_apart(const std::vector<Definition>& file, const std::vector<Definition>& shared) {
  const auto is_constant = [](const Definition& d) { return find_constant(d.name).has_value(); };
  const auto is_in_file = [&](const Definition& d) {
    return std::ranges::find(file, d.name, &Definition::name) != file.end();
  };
  return std::ranges::none_of(shared, is_in_file) && std::ranges::none_of(shared, is_constant) &&
         std::ranges::none_of(file, is_constant);
}

/// Formulas beside a scene file that has the same names keep the shared definitions that they use.
void keep_shared(const std::vector<Definition>& shared, std::set<std::string> names,
                 SurfaceSpec& spec) {
  names.merge(names_used_by(spec));
  const std::vector<std::string> unused = take_used(shared, names);
  for (const Definition& definition : shared) {
    if (std::ranges::find(unused, definition.name) == unused.end()) {
      spec.definitions.push_back(definition);
    }
  }
}

[[noreturn]] void refuse_nodes(const Scene& scene) {
  throw Error(Status::Input, "the nodes of a second scene, '" + scene.title + "'", {},
              "name that scene first, or copy its [[node]]s into the first scene file");
}

std::set<std::string> names_in_options(const std::vector<GivenOption>& options) {
  std::set<std::string> names;
  for (const auto& [option, text] : options) names.merge(names_in(text));
  return names;
}

bool has_own(const SceneObject& object, const std::string& name) {
  return object.from != From::Formulas && name != "t" && has_name(object.scene, name);
}

Pool pool_of(const std::vector<SceneObject>& objects, const std::vector<std::string>& common) {
  Pool pool;
  for (const std::string& assignment : common) {
    const Definition definition = parse_definition(assignment);
    const bool is_taken = std::ranges::any_of(
        objects, [&](const SceneObject& o) { return has_own(o, definition.name); });
    pool.add({assignment, definition, {}, is_taken});
  }
  for (const SceneObject& object : objects) {
    for (const std::string& assignment : object.shared) {
      Shared shared{assignment, parse_definition(assignment)};
      const bool is_lacking = object.from != From::Formulas && shared.definition.name != "t";
      if (is_lacking) shared.unless_used = unknown_override(object.scene, assignment);
      pool.add(std::move(shared));
    }
  }
  return pool;
}

/// The names of shared definitions that neither formulas nor options use.
std::vector<std::string> unused_of(const Scene& scene, const std::vector<Definition>& shared,
                                   std::set<std::string> option_names, bool apart) {
  std::vector<std::string> unused = take_used(shared, option_names);
  const std::vector<std::string> in_scene = unused_definitions(scene);
  std::erase_if(unused, [&](const std::string& name) {
    if (apart) return std::ranges::find(in_scene, name) == in_scene.end();
    return std::ranges::any_of(scene.surfaces, [&](const SurfaceSpec& spec) {
      return std::ranges::find(spec.definitions, name, &Definition::name) != spec.definitions.end();
    });
  });
  return unused;
}

}  // namespace

Scene combine_objects(const std::vector<SceneObject>& objects,
                      const std::vector<std::string>& common,
                      const std::vector<GivenOption>& options) {
  Pool pool = pool_of(objects, common);
  auto base = std::ranges::find(objects, From::File, &SceneObject::from);
  if (objects.size() == 1) base = objects.begin();
  Scene scene = base == objects.end() ? Scene() : base->scene;
  scene.surfaces.clear();
  scene.curves.clear();
  scene.points.clear();
  pool.set_time(scene);
  const std::vector<Definition> shared = pool.definitions();
  const bool apart = are_apart(scene.definitions, shared);
  std::set<std::string> option_names = names_in_options(options);
  for (auto object = objects.begin(); object != objects.end(); ++object) {
    if (object != base && !object->scene.nodes.empty()) refuse_nodes(object->scene);
    std::set<std::string> names = names_in_options(object->options);
    for (SurfaceSpec spec : object->scene.surfaces) {
      if (object->from != From::Formulas && object != base) {
        keep_definitions(object->scene, names, spec);
        keep_constants(shared, spec);
      } else if (object != base && !apart) {
        keep_shared(shared, names, spec);
      }
      scene.surfaces.push_back(std::move(spec));
    }
    option_names.merge(names);
    std::ranges::copy(object->scene.curves, std::back_inserter(scene.curves));
    std::ranges::copy(object->scene.points, std::back_inserter(scene.points));
  }
  if (apart) scene.definitions.insert(scene.definitions.end(), shared.begin(), shared.end());
  pool.settle(unused_of(scene, shared, option_names, apart), scene.definitions);
  return scene;
}

namespace {

/// Options of a texture without a picture would do nothing: throws Error (Input).
void check_textures_are_used(const std::vector<GivenOption>& options,
                             std::span<const SurfaceSpec> surfaces) {
  const auto given = std::ranges::find_if(
      options, [](const GivenOption& g) { return g.option->name.starts_with("texture-"); });
  const auto has_picture = [](const SurfaceSpec& spec) { return spec.texture.picture != nullptr; };
  if (given == options.end() || surfaces.empty() || std::ranges::any_of(surfaces, has_picture))
    return;
  throw Error(Status::Input, "there is no picture", {dashed(*given->option), "", {}},
              "--texture FILE.png is one; checker has the cells of --grid");
}

/// Colours of a scale without anything to colour would do nothing: throws Error (Input).
void check_colors_are_used(const std::vector<GivenOption>& options,
                           std::span<const SurfaceSpec> surfaces) {
  const auto given = std::ranges::find_if(options, [](const GivenOption& g) {
    return g.option->name == "colormap" || g.option->name == "color-range";
  });
  const auto has_no_color = [](const SurfaceSpec& spec) { return spec.color.empty(); };
  if (given == options.end() || surfaces.empty() || !std::ranges::all_of(surfaces, has_no_color))
    return;
  throw Error(Status::Input, "there is nothing to colour", {dashed(*given->option), "", {}},
              "--color z colours by height, --color gauss by curvature");
}

/// A colour is no formula: throws Error (Input) with the options that take one. A definition of
/// that name is meant, though.
void check_colors_are_formulas(const std::vector<GivenOption>& options,
                               std::span<const SurfaceSpec> surfaces, const Scene& scene) {
  const auto has = [](const std::vector<Definition>& definitions, const std::string& name) {
    return std::ranges::find(definitions, name, &Definition::name) != definitions.end();
  };
  for (const GivenOption& given : options) {
    const std::string& text = given.text;
    if (given.option->name != "color" || surfaces.empty() || !looks_like_color(text)) continue;
    const bool is_defined =
        has(scene.definitions, text) || std::ranges::any_of(surfaces, [&](const SurfaceSpec& spec) {
          return has(spec.definitions, text);
        });
    if (is_defined) continue;
    const std::string word = text.starts_with('#') ? "'" + text + "'" : text;
    throw Error(Status::Input, "this is a colour, not a formula",
                {dashed(*given.option), text, {0, text.size()}},
                "a surface has two sides: --front " + word + " --back " + word);
  }
}

/// Lets the object's options change what it has in the scene: its surfaces, curves or points.
template <typename Part>
void apply_to(const SceneObject& object, std::span<Part> parts, const Scene& scene) {
  constexpr bool kIsSurface = std::is_same_v<Part, SurfaceSpec>;
  for (Part& part : parts) {
    for (const auto& [option, text] : object.options) {
      const bool takes = kIsSurface || is_of_strokes(*option, !object.scene.surfaces.empty());
      if (takes) apply_option(*option, text, scene, part);
    }
  }
}

/// Which of the scene's parts are an object's.
template <typename Part>
struct Own {
  std::size_t begin = 0;
  std::size_t end = 0;

  void move_to(const std::vector<Part>& parts) { begin = std::exchange(end, end + parts.size()); }
  std::span<Part> of(std::vector<Part>& all) const {
    return std::span(all).subspan(begin, end - begin);
  }
};

/// Lets a stroke's `on` mean its object's surface under the name that it has now, and puts one with
/// u and v alone on the last surface before it. `names`: those before surfaces were numbered.
template <typename Stroke>
void put_on_surface(const std::vector<std::string>& names, const Own<SurfaceSpec>& own,
                    const Scene& scene, Stroke& stroke) {
  const bool is_on_surface = !stroke.u.empty() || !stroke.v.empty();
  if (!is_on_surface || own.end == 0) return;
  if (stroke.on.empty()) {
    stroke.on = scene.surfaces[own.end - 1].name;
    return;
  }
  std::size_t k = own.begin;
  while (k < own.end && names[k] != stroke.on) ++k;
  if (k < own.end) stroke.on = scene.surfaces[k].name;
}

}  // namespace

void apply_object_options(const std::vector<SceneObject>& objects, Scene& scene) {
  if (objects.size() == 1) {  // its options are the scene's
    for (const auto& [option, text] : objects[0].options) apply_option(*option, text, scene);
    check_colors_are_formulas(objects[0].options, scene.surfaces, scene);
    check_colors_are_used(objects[0].options, scene.surfaces);
    check_textures_are_used(objects[0].options, scene.surfaces);
    return;
  }
  struct Parts {
    Own<SurfaceSpec> surfaces;
    Own<CurveSpec> curves;
    Own<PointSpec> points;
  };
  std::vector<Parts> parts;
  Parts own;
  for (const SceneObject& object : objects) {
    own.surfaces.move_to(object.scene.surfaces);
    own.curves.move_to(object.scene.curves);
    own.points.move_to(object.scene.points);
    apply_to(object, own.surfaces.of(scene.surfaces), scene);
    apply_to(object, own.curves.of(scene.curves), scene);
    apply_to(object, own.points.of(scene.points), scene);
    check_colors_are_formulas(object.options, own.surfaces.of(scene.surfaces), scene);
    check_colors_are_used(object.options, own.surfaces.of(scene.surfaces));
    check_textures_are_used(object.options, own.surfaces.of(scene.surfaces));
    parts.push_back(own);
  }
  std::vector<std::string> names;
  for (const SurfaceSpec& spec : scene.surfaces) names.push_back(spec.name);
  number_names(scene);
  for (const Parts& p : parts) {
    for (auto& curve : p.curves.of(scene.curves)) put_on_surface(names, p.surfaces, scene, curve);
    for (auto& point : p.points.of(scene.points)) put_on_surface(names, p.surfaces, scene, point);
  }
}

}  // namespace saddle
