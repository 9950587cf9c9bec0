// Parts of a picture that are drawn by themselves.
#pragma once

#include <algorithm>

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
  PixelRect rect;  ///< of the part
  int margin = 0;  ///< pixels around it that are drawn too
  /// Samples per pixel and side; less than 1: a coarse picture, of as many samples as fit.
  double per_side = 1;

  /// Samples of the part with its margin, at least 1 each way.
  int samples_across() const { return samples(rect.width); }
  int samples_down() const { return samples(rect.height); }

  /// The whole picture in pixels.
  dvec2 size() const { return {width, height}; }

 private:
  int samples(int pixels) const {
    return std::max(1, static_cast<int>(per_side * (pixels + 2 * margin)));
  }
};

}  // namespace saddle
