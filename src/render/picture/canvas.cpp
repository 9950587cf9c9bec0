#include "render/picture/canvas.h"

#include <cassert>
#include <tuple>

#include "render/gl/gl.h"

namespace saddle {

void Canvas::draw(Renderer& renderer, const Scene& scene, const FittedCamera& camera,
                  const Look& look, const PictureSettings& picture) {
  const auto [width, height, n] = std::tuple(picture.width, picture.height, picture.antialias);
  assert(n == 1 || n == 2);
  if (!target_ || width != picture_.width || height != picture_.height || n != picture_.antialias) {
    target_.reset();  // first the old one: there need not be memory for both
    target_.emplace(width * n, height * n);
  }
  picture_ = picture;
  target_->bind();
  renderer.draw(scene, camera, {width, height, {0, 0, width, height}, 0, n}, look);
  glFinish();
}

/// Linear filtering of two by two samples to one takes their mean.
void Canvas::show(int x, int y) const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  if (!target_) return;
  target_->bind_for_reading();
  const int n = picture_.antialias;
  glBlitFramebuffer(0, 0, n * picture_.width, n * picture_.height, x, y, x + picture_.width,
                    y + picture_.height, GL_COLOR_BUFFER_BIT, GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image Canvas::read() const {
  if (!target_) return {};
  Image image(picture_.width, picture_.height);
  target_->bind();
  target_->read(0, 0, picture_.antialias, false, {0, 0, picture_.width, picture_.height}, image);
  return image;
}

}  // namespace saddle
