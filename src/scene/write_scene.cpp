// Scenes as TOML text: tables in a fixed order, what has its default left out, so that equal
// scenes give equal bytes. Source: T. Preston-Werner and others, "TOML v1.0.0", 2021.
#include <algorithm>

#include "scene/lights.h"
#include "scene/scene_file.h"
#include "scene/toml_writer.h"
#include "scene/values.h"

namespace saddle {
namespace {

bool same_value(const Number& a, const Number& b) {
  return a.text == b.text && (!a.text.empty() || a.value == b.value);
}

bool same_value(const Vector& a, const Vector& b) {
  return same_value(a.x, b.x) && same_value(a.y, b.y) && same_value(a.z, b.z);
}

bool same_value(const Color& a, const Color& b) {
  return same_value(a.r, b.r) && same_value(a.g, b.g) && same_value(a.b, b.b) &&
         same_value(a.a, b.a);
}

/// The inline table of what differs from `standard`, empty if nothing does.
InlineTable material(const Material& m, const Material& standard) {
  InlineTable table;
  if (!same_value(m.diffuse, standard.diffuse)) table.add("diffuse", toml_color(m.diffuse));
  if (!same_value(m.specular, standard.specular)) table.add("specular", toml_color(m.specular));
  if (!same_value(m.shininess, standard.shininess))
    table.add("shininess", toml_number(m.shininess));
  if (m.ambient) table.add("ambient", toml_color(*m.ambient));
  if (!same_value(m.emission, standard.emission)) table.add("emission", toml_color(m.emission));
  return table;
}

std::string parameter(const Definition& d, const std::vector<Slider>& sliders) {
  std::string value = is_toml_number(d.text) ? d.text : toml_string(d.text);
  const auto slider = std::ranges::find(sliders, d.name, &Slider::name);
  if (slider == sliders.end()) return value;
  InlineTable table;
  table.add("value", value);
  table.add("min", toml_number(slider->min));
  table.add("max", toml_number(slider->max));
  return table.text();
}

std::string definitions(const Scene& scene) {
  std::string params;
  std::string functions;
  for (const Definition& d : scene.definitions) {
    if (d.is_function) {
      functions += toml_string(display_name(d)) + " = " + toml_string(d.text) + "\n";
    } else {
      params += d.name + " = " + parameter(d, scene.sliders) + "\n";
    }
  }
  return (params.empty() ? "" : "\n[params]\n" + params) +
         (functions.empty() ? "" : "\n[functions]\n" + functions);
}

/// One name alone, several as an array.
std::string names(const std::vector<std::string>& all) {
  if (all.size() == 1) return toml_string(all[0]);
  std::string text;
  for (const std::string& name : all) text += (text.empty() ? "[" : ", ") + toml_string(name);
  return text + "]";
}

std::string range(const std::string& key, const Range& r) {
  const Range standard;
  if (r.min == standard.min && r.max == standard.max) return "";
  return key + " = [" + toml_string(r.min) + ", " + toml_string(r.max) + "]\n";
}

std::string surface(const SurfaceSpec& spec) {
  const SurfaceSpec standard;
  std::string text = "\n[[surface]]\n";
  const auto formula = [&text](const std::string& key, const std::string& value,
                               const std::string& default_value) {
    if (value != default_value) text += key + " = " + toml_string(value) + "\n";
  };
  formula("name", spec.name, standard.name);
  formula("x", spec.x, standard.x);
  formula("y", spec.y, standard.y);
  formula("z", spec.z, standard.z);
  text += range("u", spec.u) + range("v", spec.v);
  formula("color", spec.color, standard.color);
  if (!spec.color.empty()) formula("colormap", spec.colormap, standard.colormap);
  if (spec.grid_u != standard.grid_u || spec.grid_v != standard.grid_v) {
    text += "grid = [" + std::to_string(spec.grid_u) + ", " + std::to_string(spec.grid_v) + "]\n";
  }
  const InlineTable front = material(spec.front, standard.front);
  const InlineTable back = material(spec.back, standard.back);
  if (!front.empty()) text += "front = " + front.text() + "\n";
  if (!back.empty()) text += "back = " + back.text() + "\n";
  if (spec.flip) text += "flip = true\n";
  if (!same_value(spec.opacity, standard.opacity))
    text += "opacity = " + toml_number(spec.opacity) + "\n";
  if (!spec.in.empty()) text += "in = " + names(spec.in) + "\n";
  return text;
}

std::string transform(const Transform& step) {
  InlineTable table;
  const Vector& v = step.vector;
  switch (step.kind) {
    case Transform::Kind::Translate:
      table.add("translate", toml_vector(v));
      break;
    case Transform::Kind::Rotate:
      table.add("rotate", toml_numbers({step.angle, v.x, v.y, v.z}));
      break;
    case Transform::Kind::Scale:
      table.add("scale",
                same_value(v.x, v.y) && same_value(v.x, v.z) ? toml_number(v.x) : toml_vector(v));
      break;
  }
  return table.text();
}

std::string node(const SceneNode& n) {
  std::string text = "\n[[node]]\nname = " + toml_string(n.name) + "\n";
  if (!n.in.empty()) text += "in = " + toml_string(n.in) + "\n";
  std::string steps;
  for (const Transform& step : n.transform) steps += (steps.empty() ? "" : ", ") + transform(step);
  if (!steps.empty()) text += "transform = [" + steps + "]\n";
  return text;
}

std::string camera(const Camera& c) {
  const Camera standard;
  std::string text;
  if (!same_value(c.view, standard.view)) text += "view = " + toml_vector(c.view) + "\n";
  if (!same_value(c.up, standard.up)) text += "up = " + toml_vector(c.up) + "\n";
  if (c.target) text += "target = " + toml_vector(*c.target) + "\n";
  if (c.distance) text += "distance = " + toml_number(*c.distance) + "\n";
  if (!same_value(c.fov, standard.fov)) text += "fov = " + toml_number(c.fov) + "\n";
  if (c.ortho) text += "ortho = true\n";
  return text.empty() ? "" : "\n[camera]\n" + text;
}

/// As the option --clip wants it.
std::string clip(const Clip& c) {
  if (!c.box) return c.automatic ? "" : "clip = \"off\"\n";
  std::string ranges;
  for (int k = 0; k < 3; ++k) {
    ranges += (k == 0 ? "" : ",") + toml_number(c.box->low[k]) + ":" + toml_number(c.box->high[k]);
  }
  return "clip = " + toml_string(ranges) + "\n";
}

std::string pair(const GridSize& size) {
  return toml_string(std::to_string(size.u) + "x" + std::to_string(size.v));
}

std::string settings(const MeshSettings& mesh, const PictureSettings& picture) {
  const MeshSettings standard;
  const PictureSettings usual;
  std::string text;
  if (picture.width != usual.width || picture.height != usual.height) {
    text += "size = " + pair({picture.width, picture.height}) + "\n";
  }
  if (picture.antialias != usual.antialias) {
    text += "antialias = " + std::to_string(picture.antialias) + "\n";
  }
  if (picture.shading == Shading::Vertex) text += "shading = \"vertex\"\n";
  if (picture.shading == Shading::Exact) text += "shading = \"exact\"\n";
  if (picture.specular == Specular::Blinn) text += "specular = \"blinn\"\n";
  if (mesh.tolerance) {
    const std::string value = format_number(mesh.tolerance->value);
    text += "tolerance = " + (mesh.tolerance->pixels ? toml_string(value + "px") : value) + "\n";
  }
  if (mesh.normal_tolerance != standard.normal_tolerance) {
    text += "normal-tolerance = " + toml_number(mesh.normal_tolerance) + "\n";
  }
  if (mesh.max_triangles) {
    text += "max-triangles = " + std::to_string(*mesh.max_triangles) + "\n";
  }
  if (mesh.samples) text += "samples = " + pair(*mesh.samples) + "\n";
  return text;
}

std::string animation(const Animation& a) {
  const Animation standard;
  std::string text = "\n[animation]\nt = " + toml_numbers({a.from, a.to}) + "\n";
  if (!same_value(a.fps, standard.fps)) text += "fps = " + toml_number(a.fps) + "\n";
  if (a.frames != standard.frames) text += "frames = " + std::to_string(a.frames) + "\n";
  return text;
}

}  // namespace

std::string write_scene(const Scene& scene) {
  const Scene standard;
  std::string text;
  if (scene.title != standard.title) text += "title = " + toml_string(scene.title) + "\n";
  if (!same_value(scene.background, standard.background)) {
    text += "background = " + toml_color(scene.background) + "\n";
  }
  if (scene.axes) text += "axes = true\n";
  text += settings(scene.mesh, scene.picture) + clip(scene.clip);
  const Number start = scene.animation ? scene.animation->from : standard.t;
  if (!same_value(scene.t, start)) text += "t = " + toml_number(scene.t) + "\n";
  if (scene.lights.empty()) text += "light = []\n";
  text += definitions(scene);
  for (const SurfaceSpec& spec : scene.surfaces) text += surface(spec);
  for (const SceneNode& n : scene.nodes) text += node(n);
  text += write_lights(scene.lights) + camera(scene.camera);
  if (scene.animation) text += animation(*scene.animation);
  if (text.starts_with('\n')) text.erase(0, 1);  // no empty line before the first table
  return text;
}

}  // namespace saddle
