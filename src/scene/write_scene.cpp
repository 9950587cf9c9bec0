// Scenes as TOML text: tables in a fixed order, what has its default left out, so that equal
// scenes give equal bytes. Source: T. Preston-Werner and others, "TOML v1.0.0", 2021.
#include <algorithm>
#include <array>
#include <cstdio>
#include <string_view>

#include "scene/color.h"
#include "scene/lights.h"
#include "scene/scene_file.h"
#include "scene/values.h"

namespace saddle {
namespace {

/// A basic string with everything escaped that TOML wants escaped.
std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      result += {'\\', c};
    } else if (byte < 0x20 || byte == 0x7f) {
      std::array<char, 7> escape{};  // \uXXXX and the end
      std::snprintf(escape.data(), escape.size(), "\\u%04X", static_cast<unsigned>(byte));
      result += escape.data();
    } else {
      result += c;
    }
  }
  return result + '"';
}

/// Integers have 64 bits in TOML, which this many digits always fit.
constexpr std::size_t kIntegerDigits = 18;

/// With a point where TOML would see an integer of more than 64 bits.
std::string number(const Number& n) {
  if (!n.text.empty()) return toml_string(n.text);
  const std::string text = format_number(n.value);
  const bool integer = text.find_first_of(".e") == std::string::npos;
  return integer && text.size() > kIntegerDigits ? text + ".0" : text;
}

std::string numbers(const std::vector<Number>& all) {
  std::string text;
  for (const Number& n : all) text += (text.empty() ? "[" : ", ") + number(n);
  return text + "]";
}

std::string vector(const Vector& v) {
  return numbers({v.x, v.y, v.z});
}

bool same(const Number& a, const Number& b) {
  return a.text == b.text && (!a.text.empty() || a.value == b.value);
}

bool same(const Vector& a, const Vector& b) {
  return same(a.x, b.x) && same(a.y, b.y) && same(a.z, b.z);
}

bool same(const Color& a, const Color& b) {
  return same(a.r, b.r) && same(a.g, b.g) && same(a.b, b.b) && same(a.a, b.a);
}

/// A string where eight bits per channel hold the colour, numbers where they don't.
std::string color(const Color& c) {
  const std::string text = format_color(c);
  if (same(parse_color("color", text), c)) return toml_string(text);
  return same(c.a, 1) ? numbers({c.r, c.g, c.b}) : numbers({c.r, c.g, c.b, c.a});
}

/// An inline table, or what stands in one.
class InlineTable {
 public:
  void add(const std::string& key, const std::string& value) {
    inside_ += (inside_.empty() ? "" : ", ") + key + " = " + value;
  }
  bool empty() const { return inside_.empty(); }
  std::string text() const { return "{ " + inside_ + " }"; }

 private:
  std::string inside_;
};

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Drops the digits that `text` begins with, and says how many there were.
std::size_t skip_digits(std::string_view& text) {
  const std::size_t count = std::ranges::find_if_not(text, is_digit) - text.begin();
  text.remove_prefix(count);
  return count;
}

/// Whether a number of the formula language means the same in TOML, which wants digits on both
/// sides of a point and no leading zeros.
bool is_toml_number(std::string_view text) {
  if (text.starts_with('-')) text.remove_prefix(1);
  const bool zero_first = text.starts_with('0');
  const std::size_t integer = skip_digits(text);
  if (integer == 0 || (zero_first && integer > 1)) return false;
  if (text.empty()) return integer <= kIntegerDigits;
  if (text.starts_with('.')) {
    text.remove_prefix(1);
    if (skip_digits(text) == 0) return false;
  }
  if (text.empty()) return true;
  if (text[0] != 'e' && text[0] != 'E') return false;
  text.remove_prefix(1);
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  return skip_digits(text) > 0 && text.empty();
}

/// The inline table of what differs from `standard`, empty if nothing does.
InlineTable material(const Material& m, const Material& standard) {
  InlineTable table;
  if (!same(m.diffuse, standard.diffuse)) table.add("diffuse", color(m.diffuse));
  if (!same(m.specular, standard.specular)) table.add("specular", color(m.specular));
  if (!same(m.shininess, standard.shininess)) table.add("shininess", number(m.shininess));
  if (m.ambient) table.add("ambient", color(*m.ambient));
  if (!same(m.emission, standard.emission)) table.add("emission", color(m.emission));
  return table;
}

std::string parameter(const Definition& d, const std::vector<Slider>& sliders) {
  std::string value = is_toml_number(d.text) ? d.text : toml_string(d.text);
  const auto slider = std::ranges::find(sliders, d.name, &Slider::name);
  if (slider == sliders.end()) return value;
  InlineTable table;
  table.add("value", value);
  table.add("min", number(slider->min));
  table.add("max", number(slider->max));
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
  if (!same(spec.opacity, standard.opacity)) text += "opacity = " + number(spec.opacity) + "\n";
  if (!spec.in.empty()) text += "in = " + names(spec.in) + "\n";
  return text;
}

std::string transform(const Transform& step) {
  InlineTable table;
  const Vector& v = step.vector;
  switch (step.kind) {
    case Transform::Kind::Translate:
      table.add("translate", vector(v));
      break;
    case Transform::Kind::Rotate:
      table.add("rotate", numbers({step.angle, v.x, v.y, v.z}));
      break;
    case Transform::Kind::Scale:
      table.add("scale", same(v.x, v.y) && same(v.x, v.z) ? number(v.x) : vector(v));
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
  if (!same(c.view, standard.view)) text += "view = " + vector(c.view) + "\n";
  if (!same(c.up, standard.up)) text += "up = " + vector(c.up) + "\n";
  if (c.target) text += "target = " + vector(*c.target) + "\n";
  if (c.distance) text += "distance = " + number(*c.distance) + "\n";
  if (!same(c.fov, standard.fov)) text += "fov = " + number(c.fov) + "\n";
  if (c.ortho) text += "ortho = true\n";
  return text.empty() ? "" : "\n[camera]\n" + text;
}

/// As the option --clip wants it.
std::string clip(const Clip& c) {
  if (!c.box) return c.automatic ? "" : "clip = \"off\"\n";
  std::string ranges;
  for (int k = 0; k < 3; ++k) {
    ranges += (k == 0 ? "" : ",") + number(c.box->low[k]) + ":" + number(c.box->high[k]);
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
    text += "normal-tolerance = " + number(mesh.normal_tolerance) + "\n";
  }
  if (mesh.max_triangles) {
    text += "max-triangles = " + std::to_string(*mesh.max_triangles) + "\n";
  }
  if (mesh.samples) text += "samples = " + pair(*mesh.samples) + "\n";
  return text;
}

std::string animation(const Animation& a) {
  const Animation standard;
  std::string text = "\n[animation]\nt = " + numbers({a.from, a.to}) + "\n";
  if (!same(a.fps, standard.fps)) text += "fps = " + number(a.fps) + "\n";
  if (a.frames != standard.frames) text += "frames = " + std::to_string(a.frames) + "\n";
  return text;
}

}  // namespace

std::string write_scene(const Scene& scene) {
  const Scene standard;
  std::string text;
  if (scene.title != standard.title) text += "title = " + toml_string(scene.title) + "\n";
  if (!same(scene.background, standard.background)) {
    text += "background = " + color(scene.background) + "\n";
  }
  if (scene.axes) text += "axes = true\n";
  text += settings(scene.mesh, scene.picture) + clip(scene.clip);
  const Number start = scene.animation ? scene.animation->from : standard.t;
  if (!same(scene.t, start)) text += "t = " + number(scene.t) + "\n";
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
