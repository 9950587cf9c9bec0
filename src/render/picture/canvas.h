// A scene in a window: drawn off screen when it changes, as a whole or part by part, and copied to
// the window whenever that must be painted.
#pragma once

#include <optional>

#include "base/image.h"
#include "render/gl/target.h"
#include "render/picture/renderer.h"

namespace saddle {

/// One picture in several calls: what it shows does not change between them.
struct DrawnView {
  const Scene& scene;
  const FittedCamera& camera;
  const Look& look;
};

/// Needs a current context whose own framebuffer is the window's. Each call that draws waits until
/// that is done.
class Canvas {
 public:
  /// The picture of this many pixels, with `per_side` samples per pixel and side, 2 or less; of
  /// less than one, it is shown enlarged.
  void draw(Renderer& renderer, const DrawnView& view, int width, int height, double per_side);

  /// A part of the picture that was drawn last, with `per_side` samples, 1 or 2, in place of those
  /// it has.
  void draw_part(Renderer& renderer, const DrawnView& view, const PixelRect& part, int per_side);

  /// Fills the window with black and copies the picture into it, its lower left at (x, y).
  void show(int x, int y) const;

  /// The pixels of the picture that was drawn last; of none, none.
  Image read();

 private:
  /// A target that is as large as the pictures of it that were asked for.
  struct Room {
    std::optional<Target> target;
    int width = 0;
    int height = 0;

    void fit(int wanted_width, int wanted_height);
  };
  void draw_samples(Renderer& renderer, const DrawnView& view, const Viewport& viewport);
  void copy_samples(int margin, const PixelRect& to);
  void enlarge();

  int width_ = 0;  ///< of the picture, in pixels
  int height_ = 0;
  Room pixels_;             ///< the picture, unless it is in `samples_`
  Room samples_;            ///< what was drawn last, before it becomes pixels
  double per_side_ = 1;     ///< of them
  bool is_coarse_ = false;  ///< the picture is in `samples_`
};

}  // namespace saddle
