// Long work's progress bar.
#pragma once

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

 private:
  bool shown_;
};

}  // namespace saddle
