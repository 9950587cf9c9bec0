// A framebuffer with colour and depth, larger than the picture by the samples of each pixel, and
// the averaging of its samples into the picture.
#pragma once

#include "base/image.h"
#include "render/gl/gl.h"
#include "render/gl/viewport.h"

namespace saddle {

/// RGBA of 8 bits and depth of 24, `width` x `height` samples; bound as the framebuffer until
/// another is bound. Needs a current context.
class Target {
 public:
  /// Throws Error (Machine) if OpenGL cannot draw into as much.
  Target(int width, int height);

  /// Binds it for drawing.
  void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.get()); }
  void bind_for_reading() const { glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.get()); }

  /// Waits for drawing to end and fills `rect` of `image` with the means of per_side x per_side
  /// samples, the lowest and leftmost pixel's first sample being (x, y), from the lower left.
  /// `opaque`: all alphas are known to be 255.
  void read(int x, int y, int per_side, bool opaque, const PixelRect& rect, Image& image) const;

 private:
  GlFramebuffer framebuffer_;
  GlRenderbuffer color_;
  GlRenderbuffer depth_;
};

}  // namespace saddle
