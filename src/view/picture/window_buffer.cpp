#include "view/picture/window_buffer.h"

#include <algorithm>
#include <array>

#include "render/gl/gl.h"

namespace saddle {
namespace {

/// Pixels that are copied at a time: a few milliseconds' work, between two looks at the clock.
constexpr int kBand = 512 * 1024;

/// Parts that are kept apart.
constexpr std::size_t kMostParts = 16;

/// Frames have the marks from 1 to this, in turns. Opaque things have another alpha.
constexpr unsigned char kMostMarks = 250;

bool is_empty(const PixelRect& rect) {
  return rect.width <= 0 || rect.height <= 0;
}

int area(const PixelRect& rect) {
  return is_empty(rect) ? 0 : rect.width * rect.height;
}

PixelRect intersection(const PixelRect& a, const PixelRect& b) {
  const int x = std::max(a.x, b.x);
  const int y = std::max(a.y, b.y);
  return {x, y, std::min(a.x + a.width, b.x + b.width) - x,
          std::min(a.y + a.height, b.y + b.height) - y};
}

PixelRect box_around(const PixelRect& a, const PixelRect& b) {
  const int x = std::min(a.x, b.x);
  const int y = std::min(a.y, b.y);
  return {x, y, std::max(a.x + a.width, b.x + b.width) - x,
          std::max(a.y + a.height, b.y + b.height) - y};
}

}  // namespace

void WindowBuffer::begin_frame(int width, int height, int left) {
  const bool is_same = width == width_ && height == height_ && left == left_;
  width_ = width;
  height_ = height;
  left_ = left;
  const bool is_lost = was_on_screen_ && !is_kept();
  was_on_screen_ = false;
  if (is_lost) lose({left_, 0, width_ - left_, height_});
  if (!is_same) damage_all();
}

void WindowBuffer::damage_all() {
  damaged_.clear();
  damage({left_, 0, width_ - left_, height_});
}

void WindowBuffer::damage(const PixelRect& part) {
  lose(part);
  has_news_ = true;
}

void WindowBuffer::lose(const PixelRect& part) {
  const PixelRect seen = intersection(part, {left_, 0, width_ - left_, height_});
  if (is_empty(seen)) return;
  std::erase_if(damaged_, [&](const PixelRect& other) {
    return area(intersection(other, seen)) == area(other);
  });
  if (damaged_.size() < kMostParts) return damaged_.push_back(seen);
  damaged_.back() = box_around(damaged_.back(), seen);
}

bool WindowBuffer::fill(const Canvas& canvas, Clock::time_point end) {
  while (!damaged_.empty() && Clock::now() < end) {
    // Small ones first: lists and messages are what a key has taken away.
    const auto smallest = std::ranges::min_element(damaged_, {}, area);
    PixelRect& part = *smallest;
    PixelRect band = part;
    band.height = std::clamp(kBand / std::max(1, part.width), 1, part.height);
    canvas.show(left_, height_, band);
    part.y += band.height;
    part.height -= band.height;
    if (is_empty(part)) damaged_.erase(smallest);
  }
  return damaged_.empty();
}

/// OpenGL does not say what is in the buffer after it went to the screen: the pixel in the corner
/// tells by its alpha, which the screen does not show.
void WindowBuffer::end_frame(std::span<const PixelRect> covered) {
  has_news_ = !damaged_.empty();
  for (const PixelRect& part : covered) lose(part);
  mark_ = static_cast<unsigned char>(mark_ % kMostMarks + 1);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 1, 1);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  constexpr float kMost = 255;
  glClearColor(0, 0, 0, static_cast<float>(mark_) / kMost);
  glClear(GL_COLOR_BUFFER_BIT);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_SCISSOR_TEST);
  was_on_screen_ = true;
}

bool WindowBuffer::is_kept() const {
  std::array<unsigned char, 4> pixel{};
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  return pixel[3] == mark_;
}

}  // namespace saddle
