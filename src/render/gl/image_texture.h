// A picture as a texture, for rectangles that are drawn of it.
#pragma once

#include "base/image.h"
#include "render/gl/gl.h"

namespace saddle {

/// Needs a current context.
class ImageTexture {
 public:
  explicit ImageTexture(const Image& image);

  /// OpenGL's name of it.
  unsigned name() const { return texture_.get(); }

 private:
  GlTexture texture_;
};

}  // namespace saddle
