// Scenes as TOML text: tables in a fixed order, what has its default left out, so that equal
// scenes give equal bytes. Source: T. Preston-Werner and others, "TOML v1.0.0", 2021.
#include "scene/scene_file.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <string_view>

#include "scene/color.h"

namespace saddle {
namespace {

/// A basic string with everything escaped that TOML wants escaped.
std::string quoted(std::string_view text) {
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

/// The shortest decimal that reads back as the same double.
std::string number(double value) {
  std::array<char, 32> text{};  // the longest is 24 characters
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string vector(const dvec3& v) {
  return "[" + number(v.x) + ", " + number(v.y) + ", " + number(v.z) + "]";
}

bool same(const Color& a, const Color& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

/// A string where eight bits per channel hold the colour, numbers where they don't.
std::string color(const Color& c) {
  const std::string text = format_color(c);
  if (same(parse_color("color", text), c)) return quoted(text);
  const std::string rgb = number(c.r) + ", " + number(c.g) + ", " + number(c.b);
  return "[" + rgb + (c.a == 1 ? "]" : ", " + number(c.a) + "]");
}

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}

/// Drops the digits that `text` begins with, and says how many there were.
std::size_t skip_digits(std::string_view& text) {
  const std::size_t count = std::ranges::find_if_not(text, is_digit) - text.begin();
  text.remove_prefix(count);
  return count;
}

/// Integers have 64 bits in TOML, which this many digits always fit.
constexpr std::size_t kIntegerDigits = 18;

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

std::string parameter(const std::string& text) {
  return is_toml_number(text) ? text : quoted(text);
}

/// The inline table of what differs from `standard`, empty if nothing does.
std::string material(const Material& m, const Material& standard) {
  std::string inside;
  const auto add = [&inside](const std::string& key, const std::string& value) {
    inside += (inside.empty() ? "" : ", ") + key + " = " + value;
  };
  if (!same(m.diffuse, standard.diffuse)) add("diffuse", color(m.diffuse));
  if (!same(m.specular, standard.specular)) add("specular", color(m.specular));
  if (m.shininess != standard.shininess) add("shininess", number(m.shininess));
  return inside.empty() ? "" : "{ " + inside + " }";
}

std::string definitions(const std::vector<Definition>& all) {
  std::string params;
  std::string functions;
  for (const Definition& d : all) {
    if (d.is_function) {
      functions += quoted(display_name(d)) + " = " + quoted(d.text) + "\n";
    } else {
      params += d.name + " = " + parameter(d.text) + "\n";
    }
  }
  return (params.empty() ? "" : "\n[params]\n" + params) +
         (functions.empty() ? "" : "\n[functions]\n" + functions);
}

std::string range(const std::string& key, const Range& r) {
  const Range standard;
  if (r.min == standard.min && r.max == standard.max) return "";
  return key + " = [" + quoted(r.min) + ", " + quoted(r.max) + "]\n";
}

std::string surface(const SurfaceSpec& spec) {
  const SurfaceSpec standard;
  std::string text = "\n[[surface]]\n";
  const auto formula = [&text](const std::string& key, const std::string& value,
                               const std::string& default_value) {
    if (value != default_value) text += key + " = " + quoted(value) + "\n";
  };
  formula("name", spec.name, standard.name);
  formula("x", spec.x, standard.x);
  formula("y", spec.y, standard.y);
  formula("z", spec.z, standard.z);
  text += range("u", spec.u) + range("v", spec.v);
  if (spec.grid_u != standard.grid_u || spec.grid_v != standard.grid_v) {
    text += "grid = [" + std::to_string(spec.grid_u) + ", " + std::to_string(spec.grid_v) + "]\n";
  }
  const std::string front = material(spec.front, standard.front);
  const std::string back = material(spec.back, standard.back);
  if (!front.empty()) text += "front = " + front + "\n";
  if (!back.empty()) text += "back = " + back + "\n";
  if (spec.flip) text += "flip = true\n";
  return text;
}

std::string light(const Light& l) {
  return "\n[[light]]\n" + std::string(l.directional ? "direction" : "position") + " = " +
         vector(l.position) + "\ncolor = " + color(l.color) + "\n";
}

std::string lights(const std::vector<Light>& all) {
  std::string text;
  std::string standard;
  for (const Light& l : all) text += light(l);
  for (const Light& l : default_lights()) standard += light(l);
  return text == standard ? "" : text;
}

std::string camera(const Camera& c) {
  const Camera standard;
  std::string text;
  if (c.view != standard.view) text += "view = " + vector(c.view) + "\n";
  if (c.up != standard.up) text += "up = " + vector(c.up) + "\n";
  if (c.target) text += "target = " + vector(*c.target) + "\n";
  if (c.distance) text += "distance = " + number(*c.distance) + "\n";
  if (c.fov != standard.fov) text += "fov = " + number(c.fov) + "\n";
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
  return "clip = " + quoted(ranges) + "\n";
}

}  // namespace

std::string write_scene(const Scene& scene) {
  const Scene standard;
  std::string text;
  if (scene.title != standard.title) text += "title = " + quoted(scene.title) + "\n";
  if (!same(scene.background, standard.background)) {
    text += "background = " + color(scene.background) + "\n";
  }
  text += clip(scene.clip);
  if (scene.t != standard.t) text += "t = " + number(scene.t) + "\n";
  text += definitions(scene.definitions);
  for (const SurfaceSpec& spec : scene.surfaces) text += surface(spec);
  text += lights(scene.lights) + camera(scene.camera);
  if (text.starts_with('\n')) text.erase(0, 1);  // no empty line before the first table
  return text;
}

}  // namespace saddle
