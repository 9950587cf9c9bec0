#include "scene/options/color_kinds.h"

#include "base/error.h"
#include "scene/model/color.h"
#include "scene/model/colormap.h"
#include "scene/options/materials.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {

void Paint::parse(const Given& given) const {
  *value = opaque ? opaque_color(given.option, given.text) : parse_color(given.option, given.text);
}

std::string Paint::format() const {
  return format_color(*value);
}

void Paint::read(const InFile& in) const {
  *value = in.reader.color(in.subject, in.value, !opaque);
}

std::string Paint::write() const {
  return toml_color(*value);
}

void Paint::resolve(Resolver& resolver, const std::string& name) const {
  resolver.color(name, *value, kShare);
}

void Side::parse(const Given& given) const {
  value->diffuse = opaque_color(given.option, given.text);
}

std::string Side::format() const {
  return format_color(value->diffuse);
}

void Side::read(const InFile& in) const {
  read_material(in.reader, in.subject, in.value, *value);
}

std::string Side::write_beside(const Side& standard) const {
  return write_material(*value, *standard.value);
}

void Side::resolve(Resolver& resolver, const std::string& name) const {
  resolve_material(resolver, name, *value);
}

void ColormapName::parse(const Given& given) const {
  surface->colormap = parse_colormap(given.option, given.text);
}

std::string ColormapName::format() const {
  const bool says_something =
      !surface->color.empty() && surface->colormap != SurfaceSpec{}.colormap;
  return says_something ? surface->colormap : "";
}

void ColormapName::read(const InFile& in) const {
  const std::string text = in.reader.text(in.subject, in.value, "the name of a colormap");
  if (surface->color.empty()) {
    throw in.reader.source().error(in.subject, "there is nothing to colour", in.value.span,
                                   "color = \"z\" colours by height");
  }
  surface->colormap = in.reader.in_place([&] { return parse_colormap(in.subject, text); });
}

std::string ColormapName::write() const {
  const std::string name = format();
  return name.empty() ? "" : toml_string(name);
}

}  // namespace saddle::kinds
