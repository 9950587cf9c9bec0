// Little pictures of the gallery, drawn in a thread and an OpenGL context of their own: the window
// never waits for one.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "base/image.h"
#include "render/gl/context.h"
#include "render/gl/image_texture.h"

namespace saddle {

/// All calls from the window's thread, with its context.
class Thumbnails {
 public:
  /// Pictures of this size, in pixels, drawn in `context`, which no thread has entered. `wake` is
  /// called from another thread when take() has something to do.
  Thumbnails(std::unique_ptr<Context> context, int width, int height, std::function<void()> wake);
  ~Thumbnails();
  Thumbnails(const Thumbnails&) = delete;
  Thumbnails& operator=(const Thumbnails&) = delete;

  /// Draws those that are missing, from now on.
  void go_on();
  /// Draws no more of them until go_on(). Does not wait for the one that has begun.
  void pause() { worker_.request_stop(); }

  /// Takes the pictures that have been finished since the last call; true if there are any.
  bool take();
  bool are_all_taken() const;

  /// OpenGL's name of the picture of gallery()[entry]; 0: it is not there yet, or cannot be drawn.
  unsigned texture(std::size_t entry) const;

 private:
  void draw_all(const std::stop_token& end);
  void add(Image image);

  std::unique_ptr<Context> context_;
  int width_;
  int height_;
  std::function<void()> wake_;
  std::vector<std::optional<ImageTexture>> textures_;  ///< of the gallery, as far as it is drawn
  // The worker's: how many it has added, and when it has last said so.
  std::size_t drawn_ = 0;
  std::chrono::steady_clock::time_point woken_;
  std::mutex mutex_;           ///< of `images_`
  std::vector<Image> images_;  ///< those after `textures_`; one that cannot be drawn is empty
  std::jthread worker_;
};

}  // namespace saddle
