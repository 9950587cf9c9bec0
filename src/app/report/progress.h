// Long work's progress bar.
#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace saddle {

/// A bar on standard error, if that is a terminal; nothing otherwise. It tells what the first
/// thread is at (base/activity.h), from the second second on, and is gone when this is.
class Progress {
 public:
  /// `wanted` false: nothing at all.
  explicit Progress(bool wanted);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

 private:
  void show_until(const std::stop_token& stopped);
  std::string line() const;

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::jthread thread_;  ///< the last member: it uses the others
};

}  // namespace saddle
