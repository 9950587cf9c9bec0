// TOML to Scene, a function per table. Each says first which keys the table may have.
#include "base/error.h"
#include "scene/assignments.h"
#include "scene/colormap.h"
#include "scene/lights.h"
#include "scene/prepare.h"
#include "scene/resolve.h"
#include "scene/scene_file.h"
#include "scene/toml_reader.h"
#include "scene/values.h"

namespace saddle {
namespace {

using Kind = TomlValue::Kind;

void read_params(TomlReader& reader, const TomlValue& table, Scene& scene) {
  if (table.kind != Kind::Table) throw reader.source().wrong_type("params", table, "a table");
  for (const TomlEntry& entry : table.entries) {
    const std::string& key = entry.key;
    const TomlValue& value = entry.value;
    const TomlValue* formula = &value;
    if (value.kind == Kind::Table) {
      reader.source().check_keys(key, value, {"value", "min", "max"});
      for (const char* needed : {"value", "min", "max"}) {
        if (value.find(needed) != nullptr) continue;
        throw reader.source().error(key, std::string("'") + needed + "' is missing", value.span,
                                    "for example { value = 1, min = 0, max = 2 }");
      }
      formula = value.find("value");
      scene.sliders.push_back({key, reader.number(key + ": min", *value.find("min")),
                               reader.number(key + ": max", *value.find("max"))});
    }
    const std::string text = reader.formula(key, *formula);
    reader.note("argument", key + "=" + text, entry.key_span);
    const Definition definition =
        reader.in_place([&] { return parse_definition(key + "=" + text); });
    if (definition.name != key) {
      throw reader.source().error("", "'" + key + "' is not a name", entry.key_span,
                                  "functions go into [functions]");
    }
    scene.definitions.push_back(definition);
  }
}

void read_functions(TomlReader& reader, const TomlValue& table, Scene& scene) {
  if (table.kind != Kind::Table) throw reader.source().wrong_type("functions", table, "a table");
  for (const TomlEntry& entry : table.entries) {
    const std::string& key = entry.key;
    const TomlValue& value = entry.value;
    const std::string text = reader.formula(key, value);
    reader.note("argument", key + "=" + text, entry.key_span);
    const Definition function = reader.in_place([&] { return parse_definition(key + "=" + text); });
    if (!function.is_function) {
      throw reader.source().error("", "'" + key + "' is not a function", entry.key_span,
                                  "write \"bump(s)\" = \"exp(-s*s)\"; values go into [params]");
    }
    reader.note(display_name(function), function.text, value.span);
    scene.definitions.push_back(function);
  }
}

/// A table, or the diffuse colour alone.
void read_material(TomlReader& reader, const std::string& prefix, const TomlValue& value,
                   Material& material) {
  if (value.kind != Kind::Table) {
    material.diffuse = reader.color(prefix + "diffuse", value);
    return;
  }
  reader.source().check_keys("", value,
                             {"diffuse", "specular", "ambient", "emission", "shininess"});
  const auto color = [&](const char* key, auto& into) {
    with(value, key, [&](const TomlValue& v) { into = reader.color(prefix + key, v); });
  };
  color("diffuse", material.diffuse);
  color("specular", material.specular);
  color("ambient", material.ambient);
  color("emission", material.emission);
  with(value, "shininess",
       [&](const TomlValue& v) { material.shininess = reader.number(prefix + "shininess", v); });
}

Range read_range(TomlReader& reader, const std::string& subject, const TomlValue& value) {
  if (value.kind != Kind::Array || value.items.size() != 2) {
    throw reader.source().wrong_type(subject, value, "two ends, such as [\"0\", \"2*pi\"]");
  }
  Range range{reader.formula(subject, value.items[0]), reader.formula(subject, value.items[1])};
  reader.note(subject, range.min + ":" + range.max, value.span);
  return range;
}

std::vector<std::string> read_names(TomlReader& reader, const std::string& subject,
                                    const TomlValue& value) {
  constexpr const char* kWanted = "a name, or an array of names";
  if (value.kind != Kind::Array) return {reader.text(subject, value, kWanted)};
  if (value.items.empty()) {
    throw reader.source().error(subject, "there is no node in it", value.span,
                                "leave it out, and the surface is in the world");
  }
  std::vector<std::string> names;
  for (const TomlValue& item : value.items) names.push_back(reader.text(subject, item, kWanted));
  return names;
}

SurfaceSpec read_surface(TomlReader& reader, const std::string& prefix, const TomlValue& table) {
  reader.source().check_keys("surface", table,
                             {"name", "x", "y", "z", "u", "v", "color", "colormap", "grid", "front",
                              "back", "flip", "opacity", "in"});
  SurfaceSpec spec;
  const auto formula = [&](const char* key, std::string& into) {
    with(table, key, [&](const TomlValue& v) { into = reader.formula(prefix + key, v); });
  };
  with(table, "name",
       [&](const TomlValue& v) { spec.name = reader.text(prefix + "name", v, "a name"); });
  formula("x", spec.x);
  formula("y", spec.y);
  formula("z", spec.z);
  with(table, "u", [&](const TomlValue& v) { spec.u = read_range(reader, prefix + "u", v); });
  with(table, "v", [&](const TomlValue& v) { spec.v = read_range(reader, prefix + "v", v); });
  formula("color", spec.color);
  with(table, "colormap", [&](const TomlValue& v) {
    const std::string text = reader.text("colormap", v, "the name of a colormap");
    if (spec.color.empty()) {
      throw reader.source().error("colormap", "there is nothing to colour", v.span,
                                  "color = \"z\" colours by height");
    }
    spec.colormap = reader.in_place([&] { return parse_colormap("colormap", text); });
  });
  with(table, "grid", [&](const TomlValue& v) {
    const std::string text = reader.option("grid", v, "two whole numbers, [16, 16], or \"off\"");
    const GridSize lines = reader.in_place([&] { return parse_grid_lines("grid", text); });
    spec.grid_u = lines.u;
    spec.grid_v = lines.v;
  });
  with(table, "front",
       [&](const TomlValue& v) { read_material(reader, prefix + "front: ", v, spec.front); });
  with(table, "back",
       [&](const TomlValue& v) { read_material(reader, prefix + "back: ", v, spec.back); });
  with(table, "flip", [&](const TomlValue& v) { spec.flip = reader.boolean("flip", v); });
  with(table, "opacity",
       [&](const TomlValue& v) { spec.opacity = reader.number(prefix + "opacity", v); });
  with(table, "in", [&](const TomlValue& v) { spec.in = read_names(reader, prefix + "in", v); });
  if (spec.z.empty()) {
    throw reader.source().error("surface", "z has no formula", table.span,
                                "x and y default to u and v, z has no default");
  }
  return spec;
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

Camera read_camera(TomlReader& reader, const TomlValue& table) {
  reader.source().check_keys("camera", table, {"view", "up", "target", "distance", "fov", "ortho"});
  Camera camera;
  with(table, "view", [&](const TomlValue& v) { camera.view = reader.vector("view", v); });
  with(table, "up", [&](const TomlValue& v) { camera.up = reader.vector("up", v); });
  with(table, "target", [&](const TomlValue& v) { camera.target = reader.vector("target", v); });
  with(table, "distance",
       [&](const TomlValue& v) { camera.distance = reader.number("distance", v); });
  with(table, "fov", [&](const TomlValue& v) { camera.fov = reader.number("fov", v); });
  with(table, "ortho", [&](const TomlValue& v) { camera.ortho = reader.boolean("ortho", v); });
  return camera;
}

void read_animation(TomlReader& reader, const TomlValue& table, Scene& scene) {
  reader.source().check_keys("animation", table, {"t", "fps", "frames"});
  Animation& animation = scene.animation.emplace();
  with(table, "fps", [&](const TomlValue& v) { animation.fps = reader.number("fps", v); });
  with(table, "frames",
       [&](const TomlValue& v) { animation.frames = reader.whole("frames", v, 1, kMaxFrames); });
  with(table, "t", [&](const TomlValue& v) {
    const auto ends = reader.numbers("animation: t", v, 2, "two moments, such as [0, 12]");
    set_time_range(scene, ends[0], ends[1]);
  });
}

/// The keys that are options of the command line, too.
void read_settings(TomlReader& reader, const TomlValue& table, Scene& scene) {
  with(table, "size", [&](const TomlValue& v) {
    const std::string text = reader.option("size", v, "two whole numbers, such as [800, 600]");
    const GridSize size = reader.in_place([&] { return parse_pair("size", text, 1, kMaxPixels); });
    scene.picture.width = size.u;
    scene.picture.height = size.v;
  });
  with(table, "antialias", [&](const TomlValue& v) {
    scene.picture.antialias = reader.whole("antialias", v, 1, kMaxAntialias);
  });
  with(table, "shading", [&](const TomlValue& v) {
    const std::string text = reader.text("shading", v, "\"vertex\", \"pixel\" or \"exact\"");
    scene.picture.shading = reader.in_place([&] { return parse_shading("shading", text); });
  });
  with(table, "specular", [&](const TomlValue& v) {
    const std::string text = reader.text("specular", v, "\"phong\" or \"blinn\"");
    scene.picture.specular = reader.in_place([&] { return parse_specular("specular", text); });
  });
  with(table, "tolerance", [&](const TomlValue& v) {
    const std::string text = reader.option("tolerance", v, "a length: \"0.5px\", or 1e-3");
    scene.mesh.tolerance = reader.in_place([&] { return parse_tolerance("tolerance", text); });
  });
  with(table, "normal-tolerance", [&](const TomlValue& v) {
    const std::string text = reader.option("normal-tolerance", v, "an angle in degrees");
    scene.mesh.normal_tolerance =
        reader.in_place([&] { return parse_degrees("normal-tolerance", text); });
  });
  with(table, "max-triangles", [&](const TomlValue& v) {
    scene.mesh.max_triangles = reader.whole("max-triangles", v, 2, kMaxTriangles);
  });
  with(table, "samples", [&](const TomlValue& v) {
    const std::string text = reader.option("samples", v, "two whole numbers, such as [100, 50]");
    scene.mesh.samples = reader.in_place([&] { return parse_samples("samples", text); });
  });
  with(table, "clip", [&](const TomlValue& v) {
    const std::string text = reader.text("clip", v, "\"auto\", \"off\" or \"-1:1,-1:1,0:5\"");
    scene.clip = reader.in_place([&] { return parse_clip("clip", text); });
  });
}

Scene read_tables(TomlReader& reader, const TomlValue& root) {
  reader.source().check_keys("scene", root, {"title",
                                             "background",
                                             "axes",
                                             "size",
                                             "antialias",
                                             "shading",
                                             "specular",
                                             "tolerance",
                                             "normal-tolerance",
                                             "max-triangles",
                                             "samples",
                                             "clip",
                                             "t",
                                             "params",
                                             "functions",
                                             "surface",
                                             "node",
                                             "light",
                                             "camera",
                                             "animation"});
  Scene scene;
  with(root, "title",
       [&](const TomlValue& v) { scene.title = reader.text("title", v, "text in quotes"); });
  with(root, "background",
       [&](const TomlValue& v) { scene.background = reader.color("background", v, true); });
  with(root, "axes", [&](const TomlValue& v) { scene.axes = reader.boolean("axes", v); });
  read_settings(reader, root, scene);
  with(root, "params", [&](const TomlValue& v) { read_params(reader, v, scene); });
  with(root, "functions", [&](const TomlValue& v) { read_functions(reader, v, scene); });
  with(root, "surface", [&](const TomlValue& v) {
    for (const TomlValue& table : reader.tables("surface", v)) {
      const std::string prefix = surface_prefix(scene.surfaces.size());
      scene.surfaces.push_back(read_surface(reader, prefix, table));
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
  with(root, "camera", [&](const TomlValue& v) { scene.camera = read_camera(reader, v); });
  with(root, "animation", [&](const TomlValue& v) { read_animation(reader, v, scene); });
  with(root, "t", [&](const TomlValue& v) { scene.t = reader.number("t", v); });
  if (scene.surfaces.empty()) {
    throw reader.source().error("", "the scene has no [[surface]]", {0, 0},
                                "saddle show torus prints a scene");
  }
  return scene;
}

/// What only the whole scene tells: formulas, ranges, nodes.
void check_scene(const TomlReader& reader, const Scene& scene) {
  // Numbers may use x, y and z of the last surface.
  const std::string last = surface_prefix(scene.surfaces.size() - 1);
  const Scene resolved = reader.in_place([&] { return resolve(scene); }, last);
  for (std::size_t i = 0; i < scene.surfaces.size(); ++i) {
    reader.in_place([&] { bind_surface(resolved, resolved.surfaces[i]); }, surface_prefix(i));
  }
}

}  // namespace

Scene read_scene(const SourceText& source) {
  const TomlValue root = parse_toml(source);
  TomlPlaces places(source);
  TomlReader reader(places);
  Scene scene = read_tables(reader, root);
  check_scene(reader, scene);
  return scene;
}

}  // namespace saddle
