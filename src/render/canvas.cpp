#include "render/canvas.h"

#include <cassert>

#include "render/gl.h"

namespace saddle {

void Canvas::draw(Renderer& renderer, const Scene& scene, const FittedCamera& camera,
                  const Look& look, int width, int height, int per_side) {
  assert(per_side == 1 || per_side == 2);
  if (!target_ || width != width_ || height != height_ || per_side != per_side_) {
    target_.reset();  // first the old one: there need not be memory for both
    target_.emplace(width * per_side, height * per_side);
  }
  width_ = width;
  height_ = height;
  per_side_ = per_side;
  target_->bind();
  renderer.draw(scene, camera, {width, height, {0, 0, width, height}, 0, per_side}, look);
  glFinish();
}

/// Linear filtering of two by two samples to one takes their mean.
void Canvas::show(int x, int y) const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  if (!target_) return;
  target_->bind_for_reading();
  glBlitFramebuffer(0, 0, width_ * per_side_, height_ * per_side_, x, y, x + width_, y + height_,
                    GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace saddle
