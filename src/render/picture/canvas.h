// A scene in a window: drawn off screen when it changes, as a whole or part by part, and copied to
// the window whenever that must be painted.
#pragma once

#include <optional>
#include <vector>

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
  /// The picture of this many pixels, with `per_side` samples per pixel and side, `finest` (1 or 2)
  /// or less; one of fewer than `finest` is coarse.
  void draw(Renderer& renderer, const DrawnView& view, int width, int height, double per_side,
            int finest);

  /// A part of the picture, which was coarse as a whole, with all of its samples. In all of its
  /// parts it is the picture that draw() would have made. False: it has paused.
  bool draw_part(Renderer& renderer, const DrawnView& view, const PixelRect& part);
  /// It has all parts.
  void finish() { is_coarse_ = false; }

  /// Fills a part of a window of this height with the picture, which has its lower left at (x, 0),
  /// and with black beside it. Returns when that is done.
  void show(int x, int window_height, const PixelRect& part) const;

  /// The parts of that window whose pixels are others than at the last call.
  std::vector<PixelRect> take_changes(int x, int window_height);

  /// The pixels of the picture that was drawn last; of none or a coarse one, none.
  Image read() const;

 private:
  /// A target that is as large as the picture in it.
  struct Samples {
    std::optional<Target> target;
    int width = 0;
    int height = 0;
    double per_side = 1;  ///< of the picture that is in it

    void fit(const Viewport& viewport);
  };
  Viewport whole(double per_side) const;
  void add_part(const PixelRect& part);
  void copy(const Samples& from, const PixelRect& part, int x) const;

  int width_ = 0;  ///< of the picture, in pixels
  int height_ = 0;
  int finest_ = 1;
  Samples fine_;
  Samples coarse_;
  bool is_coarse_ = false;        ///< but for parts of it
  std::vector<PixelRect> parts_;  ///< those that are fine, rows of them together
  std::vector<PixelRect> changes_;
};

}  // namespace saddle
