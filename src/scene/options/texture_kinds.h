// Textures as values of options and scene keys.
#pragma once

#include <string>

#include "scene/model/scene.h"
#include "scene/options/value_source.h"

namespace saddle::kinds {

/// The picture of a texture, or a chequerboard; "off": none.
struct TexturePictureOf {
  Texture* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

/// How often the picture fits into the ranges, MxN.
struct TextureRepeat {
  GridSize* value;

  void parse(const Given& given) const;
  std::string format() const;
  void read(const InFile& in) const;
  std::string write() const;
};

}  // namespace saddle::kinds
