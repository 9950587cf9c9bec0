#include "app/report/progress.h"

#include <algorithm>
#include <cmath>

#include "base/format.h"
#include "base/standard_streams.h"

namespace saddle {
namespace {

constexpr int kBarCells = 30;  // of the bar

}  // namespace

Progress::Progress(bool wanted) : shown_(wanted && standard_error_is_terminal()) {}

Progress::~Progress() {
  if (shown_) clear_status();
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
  show_status('[' + std::string(static_cast<std::size_t>(full), '#') +
              std::string(static_cast<std::size_t>(kBarCells - full), ' ') + "] " +
              std::to_string(std::lround(100 * share)) + " % " + what);
}

}  // namespace saddle
