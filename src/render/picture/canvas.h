// A scene in a window: drawn off screen when it changes, copied to the window whenever that must be
// painted.
#pragma once

#include <optional>

#include "base/image.h"
#include "render/gl/target.h"
#include "render/picture/renderer.h"

namespace saddle {

/// Needs a current context whose own framebuffer is the window's.
class Canvas {
 public:
  /// Draws a picture of this size, with 1 or 2 samples per pixel and side, and waits until it is
  /// there.
  void draw(Renderer& renderer, const Scene& scene, const FittedCamera& camera, const Look& look,
            const PictureSettings& picture);

  /// Fills the window with black and copies the picture into it, its lower left at (x, y).
  void show(int x, int y) const;

  /// The pixels of the picture that was drawn last; of none, none.
  Image read() const;

 private:
  std::optional<Target> target_;
  PictureSettings picture_;  ///< that the target is for
};

}  // namespace saddle
