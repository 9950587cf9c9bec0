#include "render/shading/colormap_textures.h"

#include <cmath>
#include <cstdint>
#include <vector>

#include "scene/model/colormap.h"

namespace saddle {
namespace {

GlTexture make_texture(const std::string& colormap) {
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < kColormapTexels; ++i) {
    const dvec3 color = colormap_at(colormap, i / (kColormapTexels - 1.0));
    for (int k = 0; k < 3; ++k) {
      texels.push_back(static_cast<std::uint8_t>(std::lround(255 * color[k])));
    }
    texels.push_back(255);
  }
  auto texture = make_name<GlTexture>(glGenTextures);
  glBindTexture(GL_TEXTURE_2D, texture.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kColormapTexels, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  return texture;
}

}  // namespace

void ColormapTextures::bind(const std::string& colormap) {
  auto found = textures_.find(colormap);
  if (found == textures_.end()) found = textures_.emplace(colormap, make_texture(colormap)).first;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, found->second.get());
}

}  // namespace saddle
