// A scene in a window: drawn off screen when it changes, copied to the window whenever that wants
// to be painted.
#pragma once

#include <optional>

#include "render/renderer.h"
#include "render/target.h"

namespace saddle {

/// Needs a current context whose own framebuffer is the window's.
class Canvas {
 public:
  /// Draws a picture of width x height pixels, with `per_side` samples per pixel and side, 1 or 2,
  /// and waits until it is there.
  void draw(Renderer& renderer, const Scene& scene, const FittedCamera& camera, const Look& look,
            int width, int height, int per_side);

  /// Fills the window with black and copies the picture into it, its lower left at (x, y).
  void show(int x, int y) const;

 private:
  std::optional<Target> target_;
  int width_ = 0;
  int height_ = 0;
  int per_side_ = 1;
};

}  // namespace saddle
