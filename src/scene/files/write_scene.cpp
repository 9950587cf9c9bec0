// Scenes as TOML text: tables in a fixed order, what has its default left out, so that equal
// scenes give equal bytes. Source: T. Preston-Werner and others, "TOML v1.0.0", 2021.
#include <algorithm>

#include "scene/options/lights.h"
#include "scene/options/options.h"
#include "scene/toml/scene_file.h"
#include "scene/toml/toml_writer.h"

namespace saddle {
namespace {

std::string parameter(const Definition& d, const std::vector<Slider>& sliders) {
  std::string value = is_toml_number(d.text) ? d.text : toml_string(d.text);
  const auto slider = std::ranges::find(sliders, d.name, &Slider::name);
  if (slider == sliders.end()) return value;
  InlineTable table;
  table.add("value", value);
  if (!slider->choices.empty()) {
    table.add("choices", toml_names(slider->choices));
    return table.text();
  }
  table.add("min", toml_number(slider->min));
  table.add("max", toml_number(slider->max));
  if (slider->step != 0 || !slider->step.text.empty()) {
    table.add("step", toml_number(slider->step));
  }
  return table.text();
}

std::string definitions(const Scene& scene) {
  std::string params;
  std::string functions;
  for (const Definition& d : scene.definitions) {
    if (d.is_function) {
      functions += toml_string(display_name(d)) + " = " + toml_string(d.text) + "\n";
    } else {
      params += toml_key(d.name) + " = " + parameter(d, scene.sliders) + "\n";
    }
  }
  return (params.empty() ? "" : "\n[params]\n" + params) +
         (functions.empty() ? "" : "\n[functions]\n" + functions);
}

/// A surface's own.
std::string definitions(const SurfaceSpec& spec) {
  InlineTable params;
  InlineTable functions;
  for (const Definition& d : spec.definitions) {
    if (d.is_function) {
      functions.add(toml_string(display_name(d)), toml_string(d.text));
    } else {
      params.add(toml_key(d.name), parameter(d, spec.sliders));
    }
  }
  return (params.empty() ? "" : "params = " + params.text() + "\n") +
         (functions.empty() ? "" : "functions = " + functions.text() + "\n");
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
      table.add("scale", v.x == v.y && v.x == v.z ? toml_number(v.x) : toml_vector(v));
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

}  // namespace

std::string write_scene(const Scene& scene) {
  std::string text = write_keys(Table::Scene, scene);
  if (scene.lights.empty()) text += "light = []\n";
  text += definitions(scene);
  for (const SurfaceSpec& spec : scene.surfaces) {
    if (!spec.is_stroke())
      text += "\n[[surface]]\n" + write_keys(spec, scene.theme) + definitions(spec);
  }
  for (const CurveSpec& curve : scene.curves) text += "\n[[curve]]\n" + write_keys(curve);
  for (const PointSpec& point : scene.points) text += "\n[[point]]\n" + write_keys(point);
  for (const SceneNode& n : scene.nodes) text += node(n);
  text += write_lights(scene.lights);
  const std::string camera = write_keys(Table::Camera, scene);
  if (!camera.empty()) text += "\n[camera]\n" + camera;
  if (scene.animation) text += "\n[animation]\n" + write_keys(Table::Animation, scene);
  if (text.starts_with('\n')) text.erase(0, 1);  // no empty line before the first table
  return text;
}

}  // namespace saddle
