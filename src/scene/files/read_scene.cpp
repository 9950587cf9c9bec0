// TOML to Scene, a function per table. Each says first which keys the table may have.
#include <algorithm>
#include <functional>
#include <iterator>

#include "base/error.h"
#include "formula/lexer.h"
#include "formula/syntax.h"
#include "scene/model/assignments.h"
#include "scene/model/bind_stroke.h"
#include "scene/model/choices.h"
#include "scene/model/object_names.h"
#include "scene/model/prepare.h"
#include "scene/model/theme.h"
#include "scene/options/lights.h"
#include "scene/options/options.h"
#include "scene/options/resolve.h"
#include "scene/options/scene_limits.h"
#include "scene/toml/scene_file.h"
#include "scene/toml/toml_reader.h"
#include "scene/toml/toml_writer.h"

namespace saddle {
namespace {

using Kind = TomlValue::Kind;

/// Definitions of the scene, or of a surface, whose prefix completes what messages call them.
struct Definitions {
  std::string prefix;
  std::vector<Definition>& definitions;
  std::vector<Slider>& sliders;
};

/// Names of choices: at least two, all different, none of them a number or empty.
std::vector<std::string> read_choices(TomlReader& reader, const std::string& subject,
                                      const TomlValue& value) {
  constexpr const char* kWanted = "names, such as [\"sun\", \"lamp\"]";
  if (value.kind != Kind::Array) throw reader.source().wrong_type(subject, value, kWanted);
  std::vector<std::string> names;
  for (const TomlValue& item : value.items) {
    const std::string name = reader.text(subject, item, kWanted);
    const bool is_known = std::ranges::find(names, name) != names.end();
    if (name.empty() || is_toml_number(name) || is_known) {
      throw reader.source().error(subject,
                                  is_known ? "'" + name + "' is there twice"
                                           : "'" + name + "' cannot be the name of a choice",
                                  item.span, "for example choices = [\"sun\", \"lamp\"]");
    }
    names.push_back(name);
  }
  if (names.size() < 2) {
    throw reader.source().error(subject, "a choice is between two names or more", value.span,
                                "for example choices = [\"sun\", \"lamp\"]");
  }
  return names;
}

/// The table of a parameter with a slider or with choices.
Slider read_slider(TomlReader& reader, const std::string& key, const std::string& name,
                   const TomlValue& table) {
  const TomlValue* const choices = table.find("choices");
  reader.source().check_keys(
      key, table,
      choices == nullptr ? std::vector<std::string>{"value", "min", "max", "step", "choices"}
                         : std::vector<std::string>{"value", "choices"});
  for (const char* needed : {"value", "min", "max"}) {
    const bool is_needed = choices == nullptr || std::string_view(needed) == "value";
    if (!is_needed || table.find(needed) != nullptr) continue;
    throw reader.source().error(
        key, std::string("'") + needed + "' is missing", table.span,
        "for example { value = 1, min = 0, max = 2 } or { value = 0, choices = [\"a\", \"b\"] }");
  }
  Slider slider{.name = meant_name(key)};
  if (choices != nullptr) {
    set_choices(slider, read_choices(reader, name + ": choices", *choices));
    return slider;
  }
  slider.min = reader.number(name + ": min", *table.find("min"));
  slider.max = reader.number(name + ": max", *table.find("max"));
  with(table, "step", [&](const TomlValue& v) { slider.step = reader.number(name + ": step", v); });
  return slider;
}

void read_params(TomlReader& reader, const TomlValue& table, const Definitions& to) {
  if (table.kind != Kind::Table) throw reader.source().wrong_type("params", table, "a table");
  for (const TomlEntry& entry : table.entries) {
    const std::string& key = entry.key;
    const TomlValue& value = entry.value;
    const TomlValue* formula = &value;
    if (value.kind == Kind::Table) {
      to.sliders.push_back(read_slider(reader, key, to.prefix + key, value));
      formula = value.find("value");
    }
    const std::string text = reader.formula(to.prefix + key, *formula);
    reader.note("argument", key + "=" + text, entry.key_span);
    Definition definition = reader.in_place([&] { return parse_definition(key + "=" + text); });
    if (definition.name != meant_name(key)) {
      throw reader.source().error("", "'" + key + "' is not a name", entry.key_span,
                                  "functions go into [functions]");
    }
    reader.in_place([&] { take_choice(to.sliders, to.definitions, definition); }, to.prefix);
    to.definitions.push_back(definition);
  }
}

void read_functions(TomlReader& reader, const TomlValue& table, const Definitions& to) {
  if (table.kind != Kind::Table) throw reader.source().wrong_type("functions", table, "a table");
  for (const TomlEntry& entry : table.entries) {
    const std::string& key = entry.key;
    const TomlValue& value = entry.value;
    const std::string text = reader.formula(to.prefix + key, value);
    reader.note("argument", key + "=" + text, entry.key_span);
    const Definition function = reader.in_place([&] { return parse_definition(key + "=" + text); });
    if (!function.is_function) {
      throw reader.source().error("", "'" + key + "' is not a function", entry.key_span,
                                  "write \"bump(s)\" = \"exp(-s*s)\"; values go into [params]");
    }
    reader.note(to.prefix + display_name(function), function.text, value.span);
    to.definitions.push_back(function);
  }
}

void read_definitions(TomlReader& reader, const TomlValue& table, const Definitions& to) {
  with(table, "params", [&](const TomlValue& v) { read_params(reader, v, to); });
  with(table, "functions", [&](const TomlValue& v) { read_functions(reader, v, to); });
}

SurfaceSpec read_surface(TomlReader& reader, const std::string& prefix, const TomlValue& table,
                         Theme theme) {
  TomlValue meant = table;  // a range may be called φ
  for (TomlEntry& entry : meant.entries) entry.key = meant_name(entry.key);
  SurfaceSpec spec = themed_surface(theme);
  read_definitions(reader, meant, {prefix, spec.definitions, spec.sliders});
  read_keys(reader, prefix, meant, spec);
  std::vector<std::string> keys = keys_of(spec);
  keys.insert(keys.end(), {"params", "functions"});
  reader.source().check_keys("surface", meant, keys);
  if (!has_height(spec)) {
    const auto& [u, v] = spec.parameters;
    throw reader.source().error("surface", "z has no formula", table.span,
                                "x and y default to " + u + " and " + v +
                                    ", z has no default: for example z = \"" + u + "*" + v + "\"");
  }
  return spec;
}

/// The keys of [[curve]] or [[point]].
std::vector<std::string> stroke_keys(Table table) {
  std::vector<std::string> keys = keys_of(Table::Stroke);
  std::ranges::copy(keys_of(table), std::back_inserter(keys));
  return keys;
}

/// A [[curve]] or a [[point]].
template <typename Stroke>
Stroke read_stroke(TomlReader& reader, const char* name, Table table, const std::string& prefix,
                   const TomlValue& value) {
  reader.source().check_keys(name, value, stroke_keys(table));
  Stroke stroke;
  read_keys(reader, prefix, value, stroke);
  reader.note(prefix, "", value.span);
  return stroke;
}

/// One of { translate = [..] }, { rotate = [ANGLE, X, Y, Z] }, { scale = .. }.
Transform read_transform(TomlReader& reader, const std::string& prefix, const TomlValue& table) {
  reader.source().check_keys("transform", table, {"translate", "rotate", "scale"});
  if (table.entries.size() != 1) {
    throw reader.source().error("transform", "each step is one of translate, rotate and scale",
                                table.span,
                                "for example [ { rotate = [90, 0, 0, 1] }, { scale = 2 } ]");
  }
  const auto& [key, key_span, value] = table.entries[0];
  Transform step;
  if (key == "translate") {
    step.vector = reader.vector(prefix + key, value);
  } else if (key == "rotate") {
    step.kind = Transform::Kind::Rotate;
    const auto n = reader.numbers(prefix + key, value, 4, "an angle and an axis, [90, 0, 0, 1]");
    step.angle = n[0];
    step.vector = {n[1], n[2], n[3]};
  } else {
    step.kind = Transform::Kind::Scale;
    if (value.kind == Kind::Array) {
      step.vector = reader.vector(prefix + key, value);
    } else {
      const Number factor = reader.number(prefix + key, value, "a number, or three of them");
      step.vector = {factor, factor, factor};
    }
  }
  return step;
}

SceneNode read_node(TomlReader& reader, const TomlValue& table) {
  reader.source().check_keys("node", table, {"name", "in", "transform"});
  SceneNode node;
  const TomlValue* const name = table.find("name");
  if (name == nullptr) {
    throw reader.source().error("node", "'name' is missing", table.span,
                                "surfaces, lights and nodes refer to a node by its name");
  }
  node.name = reader.text("name", *name, "a name");
  const std::string prefix = node_prefix(node);
  reader.note(prefix + "name", node.name, name->span);
  if (node.name.empty() || node.name == "eye" || node.name == "world") {
    throw reader.source().error("node", "a node cannot be called '" + node.name + "'", name->span,
                                "choose another name");
  }
  with(table, "in",
       [&](const TomlValue& v) { node.in = reader.text(prefix + "in", v, "the name of a node"); });
  with(table, "transform", [&](const TomlValue& v) {
    if (v.kind != Kind::Array) {
      throw reader.source().wrong_type("transform", v, "a list such as [ { scale = 2 } ]");
    }
    for (const TomlValue& step : v.items) {
      node.transform.push_back(read_transform(reader, prefix, step));
    }
  });
  return node;
}

/// [camera] or [animation].
void read_table(TomlReader& reader, const TomlValue& root, const char* name, Table table,
                Scene& scene) {
  with(root, name, [&](const TomlValue& v) {
    reader.source().check_keys(name, v, keys_of(table));
    if (table == Table::Animation) scene.animation.emplace();
    read_keys(table, reader, "", v, scene);
  });
}

/// The theme in place of the file's. Values that the file has stay.
void take_theme(const std::optional<Theme>& theme, const TomlValue& root, Scene& scene) {
  if (!theme) return;
  const Color background = scene.background;
  change_theme(scene, *theme);
  if (root.find("background") != nullptr) scene.background = background;
}

Scene read_tables(TomlReader& reader, const TomlValue& root, const std::optional<Theme>& theme) {
  std::vector<std::string> keys = keys_of(Table::Scene);
  for (const char* table : {"params", "functions", "surface", "curve", "point", "node", "light",
                            "camera", "animation"}) {
    keys.emplace_back(table);
  }
  reader.source().check_keys("scene", root, keys);
  Scene scene;
  read_table(reader, root, "animation", Table::Animation, scene);
  read_keys(Table::Scene, reader, "", root, scene);  // the moment may be another than its start
  take_theme(theme, root, scene);
  read_table(reader, root, "camera", Table::Camera, scene);
  read_definitions(reader, root, {"", scene.definitions, scene.sliders});
  with(root, "surface", [&](const TomlValue& v) {
    for (const TomlValue& table : reader.tables("surface", v)) {
      const std::string prefix = surface_prefix(scene.surfaces.size());
      scene.surfaces.push_back(read_surface(reader, prefix, table, scene.theme));
    }
  });
  with(root, "curve", [&](const TomlValue& v) {
    for (const TomlValue& table : reader.tables("curve", v)) {
      const std::string prefix = curve_prefix(scene.curves.size());
      scene.curves.push_back(read_stroke<CurveSpec>(reader, "curve", Table::Curve, prefix, table));
    }
  });
  with(root, "point", [&](const TomlValue& v) {
    for (const TomlValue& table : reader.tables("point", v)) {
      const std::string prefix = point_prefix(scene.points.size());
      scene.points.push_back(read_stroke<PointSpec>(reader, "point", Table::Point, prefix, table));
    }
  });
  with(root, "node", [&](const TomlValue& v) {
    for (const TomlValue& table : reader.tables("node", v)) {
      scene.nodes.push_back(read_node(reader, table));
    }
  });
  with(root, "light", [&](const TomlValue& v) {
    scene.lights.clear();
    for (const TomlValue& table : reader.tables("light", v)) {
      scene.lights.push_back(read_light(reader, light_prefix(scene.lights.size()), table));
    }
  });
  if (scene.surfaces.empty() && scene.curves.empty() && scene.points.empty()) {
    throw reader.source().error("", "the scene has no [[surface]], [[curve]] or [[point]]", {0, 0},
                                "saddle show torus prints a scene");
  }
  number_names(scene);
  return scene;
}

/// Checks what depends on the whole scene: formulas, ranges, nodes.
void check_scene(const TomlReader& reader, const Scene& scene) {
  // Numbers may use x, y and z of the last surface.
  const std::string last = scene.surfaces.empty() ? "" : surface_prefix(scene.surfaces.size() - 1);
  const Scene resolved = reader.in_place([&] { return resolve(scene); }, last);
  check_formulas(resolved, [&](const std::string& prefix, const std::function<void()>& action) {
    reader.in_place(
        [&] {
          try {
            action();
          } catch (const Error& error) {
            const auto name = undefined_name(error);
            throw name ? with_hint_line(error, *name + " = 1 below [params] defines it") : error;
          }
        },
        prefix);
  });
}

/// Where keys belong: a key of several tables to the first.
std::span<const TomlPlaces::KnownTable> known_tables() {
  static const std::vector<TomlPlaces::KnownTable> tables = {
      {"below [[surface]]", keys_of(Table::Surface)},
      {"above all tables", keys_of(Table::Scene)},
      {"below [camera]", keys_of(Table::Camera)},
      {"below [animation]", keys_of(Table::Animation)},
      {"below [[curve]]", stroke_keys(Table::Curve)},
      {"below [[point]]", stroke_keys(Table::Point)},
      {"below [[light]]", light_keys()},
      {"below [[node]]", {"transform"}}};
  return tables;
}

Scene read(const SourceText& source, const std::optional<Theme>& theme, bool is_draft) {
  const TomlValue root = parse_toml(source);
  TomlPlaces places(source, known_tables());
  TomlReader reader(places);
  Scene scene = read_tables(reader, root, theme);
  reader.in_place([&] { check_counts(scene); });
  if (!is_draft) check_scene(reader, scene);
  return scene;
}

}  // namespace

Scene read_scene(const SourceText& source, const std::optional<Theme>& theme) {
  return read(source, theme, false);
}

Scene read_draft(const SourceText& source) {
  return read(source, {}, true);
}

}  // namespace saddle
