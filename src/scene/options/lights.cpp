#include "scene/options/lights.h"

#include <array>

#include "base/error.h"
#include "scene/toml/toml_writer.h"

namespace saddle {
namespace {

using Kind = TomlValue::Kind;

/// A value in a scene file. Its subject is what messages call it: "light 1: cutoff".
struct Reading {
  TomlReader& reader;
  std::string prefix;  ///< of the subject: "light 1: "
  std::string name;
  const TomlValue& value;

  std::string subject() const { return prefix + name; }
  const TomlPlaces& source() const { return reader.source(); }
  Number number() const { return reader.number(subject(), value); }
  Vector vector() const { return reader.vector(subject(), value); }
  Color color() const { return reader.color(subject(), value); }
};

/// A value whose expressions become numbers.
struct Resolving {
  Resolver& resolver;
  std::string prefix;
  std::string name;

  std::string subject() const { return prefix + name; }
  void number(Number& n, const Limits& limits) const { resolver.number(subject(), n, limits); }
  void vector(Vector& v) const { resolver.vector(subject(), v); }
  void direction(Vector& v) const { resolver.direction(subject(), v); }
  void color(Color& c) const { resolver.color(subject(), c, kNotNegative); }
};

/// A row: a key of a table in the scene file, and what it sets in the T that the table describes.
template <typename T>
struct LightKey {
  const char* key;
  const char* name = nullptr;  ///< in messages; not set: the key
  /// Throws Error (Input) for a wrong type.
  void (*read)(const Reading& in, T& into);
  /// As TOML; empty: the key is left out.
  std::string (*write)(const T& from);
  /// Throws Error (Input) for a number outside of its limits. Not set: there are no numbers.
  void (*resolve)(const Resolving& at, T& in) = nullptr;

  std::string name_in_messages() const { return name == nullptr ? key : name; }
};

template <typename Rows>
std::vector<std::string> keys_in(const Rows& rows) {
  std::vector<std::string> keys;
  keys.reserve(std::size(rows));
  for (const auto& row : rows) keys.emplace_back(row.key);
  return keys;
}

template <typename Rows, typename T>
void read_rows(const Rows& rows, TomlReader& reader, const std::string& prefix,
               const TomlValue& table, T& into) {
  for (const auto& row : rows) {
    with(table, row.key, [&](const TomlValue& value) {
      row.read({reader, prefix, row.name_in_messages(), value}, into);
    });
  }
}

template <typename Rows, typename T>
void resolve_rows(const Rows& rows, Resolver& resolver, const std::string& prefix, T& in) {
  for (const auto& row : rows) {
    if (row.resolve != nullptr) row.resolve({resolver, prefix, row.name_in_messages()}, in);
  }
}

// --- spot = { direction = [0, 0, -1], cutoff = 30 } ---------------------------------------------

void read_falloff(const Reading& in, Spot& spot) {
  const char* const wanted = "\"linear\" or \"smooth\"";
  const std::string text = in.reader.text(in.name, in.value, wanted);
  if (text != "linear" && text != "smooth") {
    throw in.source().error(in.subject(), std::string("must be ") + wanted, in.value.span);
  }
  spot.falloff = text == "smooth" ? Spot::Falloff::Smooth : Spot::Falloff::Linear;
}

constexpr auto kSpotKeys = std::to_array<LightKey<Spot>>({
    {.key = "direction",
     .name = "spot: direction",
     .read = [](const Reading& in, Spot& s) { s.direction = in.vector(); },
     .write = [](const Spot& s) { return toml_vector(s.direction); },
     .resolve = [](const Resolving& at, Spot& s) { at.direction(s.direction); }},
    {.key = "cutoff",
     .read = [](const Reading& in, Spot& s) { s.cutoff = in.number(); },
     .write = [](const Spot& s) { return toml_number(s.cutoff); },
     .resolve = [](const Resolving& at, Spot& s) { at.number(s.cutoff, kHalfTurn); }},
    {.key = "inner",
     .read = [](const Reading& in, Spot& s) { s.inner = in.number(); },
     .write = [](const Spot& s) { return s.inner ? toml_number(*s.inner) : ""; },
     .resolve =
         [](const Resolving& at, Spot& s) {
           if (s.inner) at.number(*s.inner, kHalfTurn);
         }},
    {.key = "exponent",
     .read = [](const Reading& in, Spot& s) { s.exponent = in.number(); },
     .write = [](const Spot& s) { return s.exponent == Number(0) ? "" : toml_number(s.exponent); },
     .resolve = [](const Resolving& at, Spot& s) { at.number(s.exponent, kNotNegative); }},
    {.key = "falloff",
     .read = read_falloff,
     .write = [](const Spot& s) -> std::string {
       return s.falloff == Spot::Falloff::Smooth ? toml_string("smooth") : "";
     }},
});

void read_spot(const Reading& in, Light& light) {
  in.source().check_keys(in.name, in.value, spot_keys());
  read_rows(kSpotKeys, in.reader, in.prefix, in.value, light.spot.emplace());
}

std::string write_spot(const Light& light) {
  if (!light.spot) return "";
  InlineTable table;
  for (const LightKey<Spot>& row : kSpotKeys) {
    const std::string value = row.write(*light.spot);
    if (!value.empty()) table.add(row.key, value);
  }
  return table.text();
}

void resolve_spot(const Resolving& at, Light& light) {
  if (!light.spot) return;
  Spot& spot = *light.spot;
  resolve_rows(kSpotKeys, at.resolver, at.prefix, spot);
  if (!spot.inner || *spot.inner <= spot.cutoff) return;
  throw Error(
      Status::Input, "the inner angle is larger than the cutoff", {at.prefix + "inner", {}, {}},
      "all is lit up to inner, nothing from cutoff on: cutoff is " + format_number(spot.cutoff));
}

// --- attenuation = [1, 0, 0], or { range = 50 } -------------------------------------------------

void read_attenuation(const Reading& in, Light& light) {
  Attenuation& attenuation = light.attenuation;
  if (in.value.kind == Kind::Table) {
    in.source().check_keys(in.name, in.value, {"range"});
    const TomlValue* const range = in.value.find("range");
    if (range == nullptr)
      throw in.source().error(in.name, "'range' is missing", in.value.span,
                              "for example { range = 50 }");
    attenuation.range = in.reader.number(in.prefix + "range", *range);
    return;
  }
  const auto n = in.reader.numbers(in.subject(), in.value, 3,
                                   "constant, linear and quadratic, [1, 0, 0], or { range = 50 }");
  attenuation.constant = n[0];
  attenuation.linear = n[1];
  attenuation.quadratic = n[2];
}

std::string write_attenuation(const Light& light) {
  const Attenuation& a = light.attenuation;
  if (a.range) {
    InlineTable table;
    table.add("range", toml_number(*a.range));
    return table.text();
  }
  const bool none = a.constant == Number(1) && a.linear == Number(0) && a.quadratic == Number(0);
  return none ? "" : toml_numbers({a.constant, a.linear, a.quadratic});
}

void resolve_attenuation(const Resolving& at, Light& light) {
  Attenuation& a = light.attenuation;
  at.number(a.constant, kNotNegative);
  at.number(a.linear, kNotNegative);
  at.number(a.quadratic, kNotNegative);
  if (a.constant == 0 && a.linear == 0 && a.quadratic == 0) {
    throw Error(Status::Input, "one of the three must be more than 0", {at.subject(), {}, {}},
                "for example attenuation = [1, 0, 0]");
  }
  if (a.range) at.resolver.number(at.prefix + "range", *a.range, kPositive);
}

// --- [[light]] ----------------------------------------------------------------------------------

void read_enabled(const Reading& in, Light& light) {
  if (in.value.kind == Kind::Boolean) {
    light.enabled = in.value.boolean ? 1 : 0;
    return;
  }
  light.enabled =
      in.reader.number(in.subject(), in.value, "true, false or an expression in quotes");
}

// A light has position or direction, and color or diffuse and specular: see check_exclusions().
constexpr auto kLightKeys = std::to_array<LightKey<Light>>({
    {.key = "frame",
     .read =
         [](const Reading& in, Light& l) {
           l.frame =
               in.reader.text(in.subject(), in.value, "\"eye\", \"world\" or the name of a node");
         },
     .write = [](const Light& l) { return l.frame == "eye" ? "" : toml_string(l.frame); }},
    {.key = "position",
     .read = [](const Reading& in, Light& l) { l.position = in.vector(); },
     .write = [](const Light& l) { return l.directional ? "" : toml_vector(l.position); },
     .resolve =
         [](const Resolving& at, Light& l) {
           if (!l.directional) at.vector(l.position);
         }},
    {.key = "direction",
     .read =
         [](const Reading& in, Light& l) {
           l.directional = true;
           l.position = in.vector();
         },
     .write = [](const Light& l) { return l.directional ? toml_vector(l.position) : ""; },
     .resolve =
         [](const Resolving& at, Light& l) {
           if (l.directional) at.direction(l.position);
         }},
    {.key = "color",
     .read = [](const Reading& in, Light& l) { l.color = in.color(); },
     .write = [](const Light& l) { return l.specular ? "" : toml_color(l.color); },
     .resolve =
         [](const Resolving& at, Light& l) {
           if (!l.specular) at.color(l.color);
         }},
    {.key = "diffuse",
     .read =
         [](const Reading& in, Light& l) {
           l.color = in.color();
           l.specular = Color{};  // unless the next key is there, too
         },
     .write = [](const Light& l) { return l.specular ? toml_color(l.color) : ""; },
     .resolve =
         [](const Resolving& at, Light& l) {
           if (l.specular) at.color(l.color);
         }},
    {.key = "specular",
     .read =
         [](const Reading& in, Light& l) {
           if (!l.specular) l.color = Color{};  // diffuse is not there
           l.specular = in.color();
         },
     .write = [](const Light& l) { return l.specular ? toml_color(*l.specular) : ""; },
     .resolve =
         [](const Resolving& at, Light& l) {
           if (l.specular) at.color(*l.specular);
         }},
    {.key = "ambient",
     .read = [](const Reading& in, Light& l) { l.ambient = in.color(); },
     .write = [](const Light& l) { return l.ambient == Color{} ? "" : toml_color(l.ambient); },
     .resolve = [](const Resolving& at, Light& l) { at.color(l.ambient); }},
    {.key = "attenuation",
     .read = read_attenuation,
     .write = write_attenuation,
     .resolve = resolve_attenuation},
    {.key = "spot", .read = read_spot, .write = write_spot, .resolve = resolve_spot},
    {.key = "enabled",
     .read = read_enabled,
     .write = [](const Light& l) { return l.enabled == Number(1) ? "" : toml_number(l.enabled); },
     .resolve = [](const Resolving& at, Light& l) { at.number(l.enabled, kAny); }},
});

/// Throws Error (Input) for keys that exclude each other.
void check_exclusions(const TomlReader& reader, const TomlValue& table) {
  const TomlValue* const color = table.find("color");
  if (color != nullptr && (table.find("diffuse") != nullptr || table.find("specular") != nullptr)) {
    throw reader.source().error("light", "color is both, diffuse and specular", color->span,
                                "give either color, or diffuse and specular");
  }
  if (table.find("direction") == nullptr) return;
  for (const char* key : {"position", "attenuation", "spot"}) {
    const TomlValue* const other = table.find(key);
    if (other == nullptr) continue;
    throw reader.source().error(
        "light", std::string("a directional light has no ") + key, other->span,
        "direction is toward a light that is far away; a point light has a position instead");
  }
}

std::string write_light(const Light& light) {
  std::string text = "\n[[light]]\n";
  for (const LightKey<Light>& row : kLightKeys) {
    const std::string value = row.write(light);
    if (!value.empty()) text += std::string(row.key) + " = " + value + "\n";
  }
  return text;
}

std::string write_all(const std::vector<Light>& lights) {
  std::string text;
  for (const Light& light : lights) text += write_light(light);
  return text;
}

}  // namespace

Light read_light(TomlReader& reader, const std::string& prefix, const TomlValue& table) {
  reader.source().check_keys("light", table, light_keys());
  check_exclusions(reader, table);
  Light light;
  read_rows(kLightKeys, reader, prefix, table, light);
  return light;
}

std::string write_lights(const std::vector<Light>& lights) {
  const std::string text = write_all(lights);
  return text == write_all(default_lights()) ? "" : text;
}

void resolve_light(Resolver& resolver, const std::string& prefix, Light& light) {
  resolve_rows(kLightKeys, resolver, prefix, light);
}

std::vector<std::string> light_keys() {
  return keys_in(kLightKeys);
}

std::vector<std::string> spot_keys() {
  return keys_in(kSpotKeys);
}

}  // namespace saddle
