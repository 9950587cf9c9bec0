#include "scene/options/materials.h"

#include <optional>
#include <vector>

#include "scene/toml/toml_writer.h"

namespace saddle {
namespace {

/// Calls `visit` with each part's key and the part, in the order in which they are written.
template <typename Visit, typename MaterialType>
void visit_parts(MaterialType& material, const Visit& visit) {
  visit("diffuse", material.diffuse);
  visit("specular", material.specular);
  visit("shininess", material.shininess);
  visit("ambient", material.ambient);
  visit("emission", material.emission);
}

std::string written(const Number& number) {
  return toml_number(number);
}

std::string written(const Color& color) {
  return toml_color(color);
}

std::string written(const std::optional<Color>& color) {
  return color ? toml_color(*color) : "";
}

struct PartReader {
  TomlReader& reader;
  const std::string& name;  ///< of the side
  const TomlValue& table;

  void operator()(const std::string& key, Number& part) const {
    with(table, key, [&](const TomlValue& v) { part = reader.number(name + ": " + key, v); });
  }
  void operator()(const std::string& key, auto& part) const {
    with(table, key, [&](const TomlValue& v) { part = reader.color(name + ": " + key, v); });
  }
};

struct PartResolver {
  Resolver& resolver;
  const std::string& name;

  void operator()(const std::string& key, Number& part) const {
    resolver.number(name + ": " + key, part, kNotNegative);
  }
  void operator()(const std::string& key, Color& part) const {
    resolver.color(name + ": " + key, part, kNotNegative);
  }
  void operator()(const std::string& key, std::optional<Color>& part) const {
    if (part) (*this)(key, *part);
  }
};

}  // namespace

void read_material(TomlReader& reader, const std::string& name, const TomlValue& value,
                   Material& material) {
  if (value.kind != TomlValue::Kind::Table) {
    material.diffuse = reader.color(name + ": diffuse", value);
    return;
  }
  std::vector<std::string> keys;
  visit_parts(material, [&](const std::string& key, const auto&) { keys.push_back(key); });
  reader.source().check_keys("", value, keys);
  visit_parts(material, PartReader{reader, name, value});
}

std::string write_material(const Material& material, const Material& standard) {
  if (material == standard) return "";
  std::vector<std::string> usual;
  visit_parts(standard,
              [&](const std::string&, const auto& part) { usual.push_back(written(part)); });
  InlineTable table;
  std::size_t i = 0;
  visit_parts(material, [&](const std::string& key, const auto& part) {
    const std::string text = written(part);
    if (text != usual[i++]) table.add(key, text);
  });
  return table.empty() ? "" : table.text();
}

void resolve_material(Resolver& resolver, const std::string& name, Material& material) {
  visit_parts(material, PartResolver{resolver, name});
}

}  // namespace saddle
