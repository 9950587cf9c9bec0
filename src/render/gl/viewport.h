// Parts of a picture that are drawn by themselves.
#pragma once

#include "base/vec.h"

namespace saddle {

/// Pixels of a picture, x and y from the upper left.
struct PixelRect {
  int x = 0, y = 0, width = 0, height = 0;
};

/// The part of a picture that is drawn. Its lower left is that of the framebuffer.
struct Viewport {
  int width = 0;  ///< of the whole picture, in pixels
  int height = 0;
  PixelRect rect;    ///< of the part
  int margin = 0;    ///< pixels around it that are drawn too
  int per_side = 1;  ///< samples per pixel and side

  /// The whole picture in pixels.
  dvec2 size() const { return {width, height}; }
};

}  // namespace saddle
