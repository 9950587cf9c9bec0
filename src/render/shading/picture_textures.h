// Pictures of textures on the GPU, each uploaded when it is first used.
#pragma once

#include <map>
#include <memory>
#include <tuple>

#include "render/gl/gl.h"
#include "scene/model/scene.h"

namespace saddle {

class PictureTextures {
 public:
  /// Binds the picture of a texture, with its wrap and filter, to the first texture unit. Throws
  /// Error (Machine) for a picture larger than the driver holds.
  void bind(const Texture& texture);

 private:
  using Key = std::tuple<std::shared_ptr<const TexturePicture>, Texture::Wrap, Texture::Filter>;

  std::map<Key, GlTexture> textures_;
};

}  // namespace saddle
