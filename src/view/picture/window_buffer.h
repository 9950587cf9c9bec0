// The window's own buffer between two frames: which of its parts have the picture as it is. Where
// the driver copies the buffer to the screen and leaves it as it was, only those that have changed
// are copied again; where it changes buffers, all of them.
#pragma once

#include <chrono>
#include <span>
#include <vector>

#include "render/picture/canvas.h"

namespace saddle {

/// Needs the window's context. Parts are in pixels from the window's upper left.
class WindowBuffer {
 public:
  using Clock = std::chrono::steady_clock;

  /// The window has this size, and the picture is at the right of `left`. To be called before
  /// fill().
  void begin_frame(int width, int height, int left);

  /// The picture has changed here.
  void damage(const PixelRect& part);
  void damage_all();
  /// The screen does not have all that has changed.
  bool has_news() const { return has_news_; }

  /// Copies what has changed, until that is over: true if nothing is left.
  bool fill(const Canvas& canvas, Clock::time_point end);

  /// The frame is drawn, with something over the picture in `covered`, and goes to the screen.
  void end_frame(std::span<const PixelRect> covered);

 private:
  void lose(const PixelRect& part);
  bool is_kept() const;

  int width_ = 0;
  int height_ = 0;
  int left_ = 0;
  std::vector<PixelRect> damaged_;
  bool has_news_ = true;
  bool was_on_screen_ = false;  ///< since the last begin_frame()
  unsigned char mark_ = 0;      ///< of the last frame
};

}  // namespace saddle
