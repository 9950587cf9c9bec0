#include "render/picture/canvas.h"

#include <algorithm>
#include <cassert>

#include "render/gl/gl.h"
#include "render/picture/tiles.h"
#include "scene/model/theme.h"

namespace saddle {
namespace {

/// While it lives, nothing outside of the lower left corner is cleared or drawn.
class Scissors {
 public:
  Scissors(int width, int height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, width, height);
  }
  ~Scissors() { glDisable(GL_SCISSOR_TEST); }
  Scissors(const Scissors&) = delete;
  Scissors& operator=(const Scissors&) = delete;
};

}  // namespace

void Canvas::Room::fit(int wanted_width, int wanted_height) {
  if (target && wanted_width <= width && wanted_height <= height) return;
  width = std::max(width, wanted_width);
  height = std::max(height, wanted_height);
  target.reset();  // first the old one: there need not be memory for both
  target.emplace(width, height);
}

void Canvas::draw(Renderer& renderer, const DrawnView& view, int width, int height,
                  double per_side) {
  if (width != width_ || height != height_) {
    for (Room* const room : {&pixels_, &samples_}) *room = Room();
  }
  width_ = width;
  height_ = height;
  const Viewport whole{width, height, {0, 0, width, height}, 0, per_side};
  is_coarse_ = per_side < 1;
  if (per_side == 1) {
    pixels_.fit(width, height);
    pixels_.target->bind();
    renderer.draw(view.scene, view.camera, whole, view.look);
  } else {
    draw_samples(renderer, view, whole);
    if (!is_coarse_) copy_samples(0, whole.rect);
  }
  glFinish();
}

void Canvas::draw_part(Renderer& renderer, const DrawnView& view, const PixelRect& part,
                       int per_side) {
  assert(per_side == 1 || per_side == 2);
  if (is_coarse_) enlarge();
  const int margin = tile_margin(widest_line(view.scene, dvec2(width_, height_)));
  draw_samples(renderer, view, {width_, height_, part, margin, static_cast<double>(per_side)});
  copy_samples(margin, part);
  glFinish();
}

void Canvas::draw_samples(Renderer& renderer, const DrawnView& view, const Viewport& viewport) {
  samples_.fit(viewport.samples_across(), viewport.samples_down());
  samples_.target->bind();
  const Scissors scissors(viewport.samples_across(), viewport.samples_down());
  renderer.draw(view.scene, view.camera, viewport, view.look);
  per_side_ = viewport.per_side;
}

/// Linear filtering of two by two samples to one takes their mean.
void Canvas::copy_samples(int margin, const PixelRect& to) {
  const auto sample = [&](int pixel) { return static_cast<int>(per_side_ * pixel); };
  pixels_.fit(width_, height_);
  pixels_.target->bind();
  samples_.target->bind_for_reading();
  const int bottom = height_ - (to.y + to.height);
  glBlitFramebuffer(sample(margin), sample(margin), sample(margin + to.width),
                    sample(margin + to.height), to.x, bottom, to.x + to.width, bottom + to.height,
                    GL_COLOR_BUFFER_BIT, GL_LINEAR);
}

/// The coarse picture becomes one of pixels, for finer parts to be put into.
void Canvas::enlarge() {
  copy_samples(0, {0, 0, width_, height_});
  is_coarse_ = false;
}

void Canvas::show(int x, int y) const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  const Room& room = is_coarse_ ? samples_ : pixels_;
  if (!room.target) return;
  const double n = is_coarse_ ? per_side_ : 1;
  const auto sample = [n](int pixel) { return std::max(1, static_cast<int>(n * pixel)); };
  room.target->bind_for_reading();
  glBlitFramebuffer(0, 0, sample(width_), sample(height_), x, y, x + width_, y + height_,
                    GL_COLOR_BUFFER_BIT, is_coarse_ ? GL_LINEAR : GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

Image Canvas::read() {
  if (is_coarse_) enlarge();
  if (!pixels_.target) return {};
  Image image(width_, height_);
  pixels_.target->bind();
  pixels_.target->read(0, 0, 1, false, {0, 0, width_, height_}, image);
  return image;
}

}  // namespace saddle
