#include "render/shading/picture_textures.h"

#include <cstddef>
#include <string>
#include <vector>

#include "base/error.h"

namespace saddle {
namespace {

GLint wrap_of(Texture::Wrap wrap) {
  switch (wrap) {
    case Texture::Wrap::Repeat:
      return GL_REPEAT;
    case Texture::Wrap::Mirror:
      return GL_MIRRORED_REPEAT;
    case Texture::Wrap::Clamp:
      return GL_CLAMP_TO_EDGE;
  }
  return GL_REPEAT;
}

void check_size(const Image& image) {
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (image.width <= most && image.height <= most) return;
  throw Error(Status::Machine,
              "the OpenGL driver holds no texture of " + std::to_string(image.width) + "x" +
                  std::to_string(image.height) + " pixels",
              {}, "it holds up to " + std::to_string(most) + " each way: make the picture smaller");
}

/// Rows from the bottom, as OpenGL has them: v goes up.
std::vector<std::uint8_t> rows_from_below(const Image& image) {
  const std::size_t row = 4 * static_cast<std::size_t>(image.width);
  std::vector<std::uint8_t> rows;
  rows.reserve(image.rgba.size());
  for (int y = image.height - 1; y >= 0; --y) {
    const std::uint8_t* const first = image.pixel(0, y);
    rows.insert(rows.end(), first, first + row);
  }
  return rows;
}

GlTexture make_picture(const Texture& texture) {
  const Image& image = texture.picture->image;
  check_size(image);
  const bool smooth = texture.filter == Texture::Filter::Smooth;
  const std::vector<std::uint8_t> rows = rows_from_below(image);
  auto made = make_name<GlTexture>(glGenTextures);
  glBindTexture(GL_TEXTURE_2D, made.get());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, image.width, image.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               rows.data());
  // From afar a pixel of the scene is the mean of the picture's pixels, not one of them.
  glGenerateMipmap(GL_TEXTURE_2D);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                  smooth ? GL_LINEAR_MIPMAP_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, smooth ? GL_LINEAR : GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap_of(texture.wrap));
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap_of(texture.wrap));
  return made;
}

}  // namespace

void PictureTextures::bind(const Texture& texture) {
  const Key key{texture.picture, texture.wrap, texture.filter};
  glActiveTexture(GL_TEXTURE0);
  auto found = textures_.find(key);
  if (found == textures_.end()) found = textures_.emplace(key, make_picture(texture)).first;
  glBindTexture(GL_TEXTURE_2D, found->second.get());
}

}  // namespace saddle
