#include "scene/read_light.h"

#include <string>

#include "base/error.h"

namespace saddle {
namespace {

using Kind = TomlValue::Kind;

Attenuation read_attenuation(TomlReader& reader, const std::string& prefix,
                             const TomlValue& value) {
  Attenuation attenuation;
  if (value.kind == Kind::Table) {
    reader.source().check_keys("attenuation", value, {"range"});
    const TomlValue* const range = value.find("range");
    if (range == nullptr) {
      throw reader.source().error("attenuation", "'range' is missing", value.span);
    }
    attenuation.range = reader.number(prefix + "range", *range);
    return attenuation;
  }
  const auto n = reader.numbers(prefix + "attenuation", value, 3,
                                "constant, linear and quadratic, [1, 0, 0], or { range = 50 }");
  attenuation.constant = n[0];
  attenuation.linear = n[1];
  attenuation.quadratic = n[2];
  return attenuation;
}

Spot read_spot(TomlReader& reader, const std::string& prefix, const TomlValue& table) {
  reader.source().check_keys("spot", table,
                             {"direction", "cutoff", "inner", "exponent", "falloff"});
  Spot spot;
  with(table, "direction",
       [&](const TomlValue& v) { spot.direction = reader.vector(prefix + "spot: direction", v); });
  with(table, "cutoff",
       [&](const TomlValue& v) { spot.cutoff = reader.number(prefix + "cutoff", v); });
  with(table, "inner",
       [&](const TomlValue& v) { spot.inner = reader.number(prefix + "inner", v); });
  with(table, "exponent",
       [&](const TomlValue& v) { spot.exponent = reader.number(prefix + "exponent", v); });
  with(table, "falloff", [&](const TomlValue& v) {
    const std::string text = reader.text("falloff", v, "\"linear\" or \"smooth\"");
    if (text != "linear" && text != "smooth") {
      throw reader.source().error("falloff", "must be \"linear\" or \"smooth\"", v.span);
    }
    spot.falloff = text == "smooth" ? Spot::Falloff::Smooth : Spot::Falloff::Linear;
  });
  return spot;
}

void read_light_colors(TomlReader& reader, const std::string& prefix, const TomlValue& table,
                       Light& light) {
  const TomlValue* const color = table.find("color");
  const TomlValue* const diffuse = table.find("diffuse");
  const TomlValue* const specular = table.find("specular");
  if (color != nullptr && (diffuse != nullptr || specular != nullptr)) {
    throw reader.source().error("light", "color is both, diffuse and specular", color->span,
                                "give either color, or diffuse and specular");
  }
  if (color != nullptr) light.color = reader.color(prefix + "color", *color);
  if (diffuse != nullptr || specular != nullptr) {
    light.color = diffuse == nullptr ? Color{} : reader.color(prefix + "diffuse", *diffuse);
    light.specular = specular == nullptr ? Color{} : reader.color(prefix + "specular", *specular);
  }
  with(table, "ambient",
       [&](const TomlValue& v) { light.ambient = reader.color(prefix + "ambient", v); });
}

}  // namespace

Light read_light(TomlReader& reader, const std::string& prefix, const TomlValue& table) {
  reader.source().check_keys("light", table,
                             {"frame", "position", "direction", "color", "diffuse", "specular",
                              "ambient", "attenuation", "spot", "enabled"});
  Light light;
  with(table, "frame", [&](const TomlValue& v) {
    light.frame = reader.text(prefix + "frame", v, "\"eye\", \"world\" or the name of a node");
  });
  with(table, "position",
       [&](const TomlValue& v) { light.position = reader.vector(prefix + "position", v); });
  if (const TomlValue* direction = table.find("direction")) {
    light.directional = true;
    light.position = reader.vector(prefix + "direction", *direction);
    for (const char* key : {"position", "attenuation", "spot"}) {
      const TomlValue* const other = table.find(key);
      if (other == nullptr) continue;
      throw reader.source().error(
          "light", std::string("a directional light has no ") + key, other->span,
          "direction is toward a light that is far away; a point light has a position instead");
    }
  }
  read_light_colors(reader, prefix, table, light);
  with(table, "attenuation",
       [&](const TomlValue& v) { light.attenuation = read_attenuation(reader, prefix, v); });
  with(table, "spot", [&](const TomlValue& v) { light.spot = read_spot(reader, prefix, v); });
  with(table, "enabled", [&](const TomlValue& v) {
    if (v.kind == Kind::Boolean) {
      light.enabled = v.boolean ? 1 : 0;
    } else {
      light.enabled =
          reader.number(prefix + "enabled", v, "true, false or an expression in quotes");
    }
  });
  return light;
}

}  // namespace saddle
