// Little pictures of the gallery, drawn one after the other while the window waits.
#pragma once

#include <chrono>
#include <cstddef>
#include <optional>
#include <vector>

#include "render/gl/image_texture.h"
#include "render/picture/renderer.h"

namespace saddle {

/// Needs the window's context from the first to the last of its calls.
class Thumbnails {
 public:
  /// Pictures of this size, in pixels; those of another size are drawn again.
  void fit(int width, int height);

  /// Draws some of those that are missing, for some hundredths of a second; true if there are any.
  bool draw();

  /// OpenGL's name of the picture of gallery()[entry]; 0: it is not drawn yet, or cannot be.
  unsigned texture(std::size_t entry) const;

 private:
  void draw_next();

  int width_ = 0;
  int height_ = 0;
  std::vector<std::optional<ImageTexture>> pictures_;  ///< of the gallery, as far as they are drawn
  std::optional<Renderer> renderer_;                   ///< while some are missing
};

}  // namespace saddle
