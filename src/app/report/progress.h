// Long work's progress bar.
#pragma once

#include <cstddef>
#include <string>

namespace saddle {

/// A bar on standard error, if that is a terminal; nothing otherwise. It is gone when this is.
class Progress {
 public:
  /// `wanted` false: nothing at all.
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The share that is done, 0 to 1, and what is being done now.
  void show(double share, const std::string& what);
  /// Frames that are done, of how many, with their rate and the time that is left. `seconds`: since
  /// the first was begun.
  void show_frames(std::size_t done, std::size_t all, double seconds);

 private:
  bool shown_;
};

}  // namespace saddle
