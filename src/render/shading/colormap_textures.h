// Colormaps on the GPU, each made when it is first used.
#pragma once

#include <map>
#include <string>

#include "render/gl/gl.h"

namespace saddle {

class ColormapTextures {
 public:
  /// Binds a texture of kColormapTexels x 1 texels to the first texture unit.
  void bind(const std::string& colormap);

 private:
  std::map<std::string, GlTexture> textures_;
};

inline constexpr int kColormapTexels = 256;

}  // namespace saddle
