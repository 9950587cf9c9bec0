#include "app/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

#include "base/format.h"

namespace saddle {
namespace {

constexpr int kBarCells = 30;  // of the bar
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::cerr << kClearLine << std::flush;
}

void Progress::show_frames(std::size_t done, std::size_t all, double seconds) {
  const double rate = seconds > 0 ? static_cast<double>(done) / seconds : 0;
  std::string what = "frame " + std::to_string(done) + " of " + std::to_string(all);
  if (rate > 0) {
    const long left = std::lround(static_cast<double>(all - done) / rate);
    what += formatted(", %.1f frames/s, %ld:%02ld left", rate, left / 60, left % 60);
  }
  show(static_cast<double>(done) / static_cast<double>(all), what);
}

void Progress::show(double share, const std::string& what) {
  if (!shown_) return;
  const int full = std::clamp(static_cast<int>(std::lround(share * kBarCells)), 0, kBarCells);
  std::cerr << kClearLine << '[' << std::string(static_cast<std::size_t>(full), '#')
            << std::string(static_cast<std::size_t>(kBarCells - full), ' ') << "] "
            << std::lround(100 * share) << " % " << what << std::flush;
}

}  // namespace saddle
