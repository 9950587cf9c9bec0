#include "scene/options/texture_kinds.h"

#include "scene/model/texture.h"
#include "scene/model/values.h"
#include "scene/toml/toml_writer.h"

namespace saddle::kinds {
namespace {

GridSize parse_repeat(const std::string& option, const std::string& text) {
  const bool is_pair = text.find('x') != std::string::npos;
  return parse_pair(option, is_pair ? text : text + "x" + text, 1, kMaxPixels);
}

}  // namespace

void TexturePictureOf::parse(const Given& given) const {
  set_picture(read_texture(given.option, given.text), *value);
}

std::string TexturePictureOf::format() const {
  return value->name.empty() ? texture_text(*value) : value->name;
}

void TexturePictureOf::read(const InFile& in) const {
  const std::string name = in.reader.text(in.subject, in.value, "a picture's file or \"checker\"");
  set_picture(in.reader.in_place([&] {
    return read_scene_texture(in.subject, name, in.reader.source().folder());
  }),
              *value);
}

std::string TexturePictureOf::write() const {
  return *value ? toml_string(texture_text(*value)) : "";
}

void TextureRepeat::parse(const Given& given) const {
  *value = parse_repeat(given.option, given.text);
}

std::string TextureRepeat::format() const {
  return std::to_string(value->u) + "x" + std::to_string(value->v);
}

void TextureRepeat::read(const InFile& in) const {
  *value = read_option(in, "two whole numbers, such as [3, 2]", parse_repeat);
}

std::string TextureRepeat::write() const {
  return "[" + std::to_string(value->u) + ", " + std::to_string(value->v) + "]";
}

}  // namespace saddle::kinds
