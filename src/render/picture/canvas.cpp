#include "render/picture/canvas.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "render/gl/gl.h"

namespace saddle {
namespace {

/// While it lives, nothing outside of a rectangle of samples is cleared or drawn.
class Scissors {
 public:
  Scissors(int x, int y, int width, int height) {
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, width, height);
  }
  ~Scissors() { glDisable(GL_SCISSOR_TEST); }
  Scissors(const Scissors&) = delete;
  Scissors& operator=(const Scissors&) = delete;
};

}  // namespace

/// Binds it, too. It has the picture and nothing else: samples beside it would shine into the rim
/// when a coarse picture is magnified.
void Canvas::Samples::fit(const Viewport& viewport) {
  per_side = viewport.per_side;
  if (!target || viewport.samples_across() != width || viewport.samples_down() != height) {
    width = viewport.samples_across();
    height = viewport.samples_down();
    target.reset();  // first the old one: there need not be memory for both
    target.emplace(width, height);
  }
  target->bind();
}

Viewport Canvas::whole(double per_side) const {
  return {width_, height_, {0, 0, width_, height_}, 0, per_side};
}

void Canvas::draw(Renderer& renderer, const DrawnView& view, int width, int height, double per_side,
                  int finest) {
  assert(finest == 1 || finest == 2);
  if (width != width_ || height != height_) {
    for (Samples* const samples : {&fine_, &coarse_}) *samples = Samples();
  }
  width_ = width;
  height_ = height;
  finest_ = finest;
  parts_.clear();
  is_coarse_ = per_side < finest;
  const Viewport viewport = whole(per_side);
  (is_coarse_ ? coarse_ : fine_).fit(viewport);
  const Scissors scissors(0, 0, viewport.samples_across(), viewport.samples_down());
  renderer.draw(view.scene, view.camera, viewport, view.look);
  glFinish();
  changes_ = {{0, 0, width, height}};
}

bool Canvas::draw_part(Renderer& renderer, const DrawnView& view, const PixelRect& part) {
  const int n = finest_;
  fine_.fit(whole(n));
  const int bottom = height_ - (part.y + part.height);
  const Scissors scissors(n * part.x, n * bottom, n * part.width, n * part.height);
  const bool is_whole = renderer.draw(view.scene, view.camera, whole(n), view.look);
  glFinish();
  if (is_whole) {
    add_part(part);
    changes_.push_back(part);
  }
  return is_whole;
}

/// Parts that stand side by side are one, and so are whole rows of them.
void Canvas::add_part(const PixelRect& part) {
  const auto joins = [](const PixelRect& a, const PixelRect& b) {
    return a.y == b.y && a.height == b.height && a.x + a.width == b.x;
  };
  if (!parts_.empty() && joins(parts_.back(), part)) {
    parts_.back().width += part.width;
  } else {
    parts_.push_back(part);
  }
  if (parts_.size() < 2 || parts_.back().width != width_) return;
  parts_[parts_.size() - 2].height += parts_.back().height;
  parts_.pop_back();
}

/// To the window. Linear filtering of two by two samples to one takes their mean.
void Canvas::copy(const Samples& from, const PixelRect& part, int x) const {
  const auto sample = [&](int pixel) { return static_cast<int>(from.per_side * pixel); };
  const int bottom = height_ - (part.y + part.height);
  const int top = bottom + part.height;
  const int right = part.x + part.width;
  from.target->bind_for_reading();
  glBlitFramebuffer(sample(part.x), sample(bottom), std::max(1, sample(right)),
                    std::max(1, sample(top)), x + part.x, bottom, x + right, top,
                    GL_COLOR_BUFFER_BIT, from.per_side == 1 ? GL_NEAREST : GL_LINEAR);
}

void Canvas::show(int x, int window_height, const PixelRect& part) const {
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  const int bottom = window_height - (part.y + part.height);
  const Scissors scissors(part.x, bottom, part.width, part.height);
  const Samples& samples = is_coarse_ ? coarse_ : fine_;
  const bool is_covered = samples.target && part.x >= x && part.x + part.width <= x + width_ &&
                          bottom + part.height <= height_;
  if (!is_covered) {
    glClearColor(0, 0, 0, 1);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  if (samples.target) {
    copy(samples, {0, 0, width_, height_}, x);
    for (const PixelRect& fine : parts_) {
      if (is_coarse_) copy(fine_, fine, x);
    }
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glFinish();
}

std::vector<PixelRect> Canvas::take_changes(int x, int window_height) {
  std::vector<PixelRect> changes = std::exchange(changes_, {});
  for (PixelRect& part : changes) {
    part.x += x;
    part.y += window_height - height_;
  }
  return changes;
}

Image Canvas::read() const {
  if (!fine_.target || is_coarse_) return {};
  Image image(width_, height_);
  fine_.target->bind();
  fine_.target->read(0, 0, finest_, false, {0, 0, width_, height_}, image);
  return image;
}

}  // namespace saddle
