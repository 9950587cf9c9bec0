#include "app/report/progress.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "base/activity.h"
#include "base/format.h"
#include "base/standard_streams.h"

namespace saddle {
namespace {

constexpr int kBarCells = 30;  // of the bar
constexpr std::chrono::seconds kQuiet(1);
constexpr std::chrono::milliseconds kBetween(200);
/// From this share on the time that is left can be told from the time that has passed.
constexpr double kEnough = 0.02;

}  // namespace

Progress::Progress(bool wanted) {
  if (!wanted || !standard_error_is_terminal()) return;
  try {
    thread_ = std::jthread([this](const std::stop_token& stopped) { show_until(stopped); });
  } catch (const std::system_error&) {
    // The system allows no more threads: there is no bar.
  }
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  thread_.request_stop();
  thread_.join();
  clear_status();
}

void Progress::show_until(const std::stop_token& stopped) {
  std::unique_lock lock(mutex_);
  const auto never = [] { return false; };
  wake_.wait_for(lock, stopped, kQuiet, never);
  while (!stopped.stop_requested()) {
    show_status(line());
    wake_.wait_for(lock, stopped, kBetween, never);
  }
}

std::string Progress::line() const {
  const ActivityNow now = current_activity();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const int full = std::clamp(static_cast<int>(std::lround(now.share * kBarCells)), 0, kBarCells);
  std::string text = '[' + std::string(static_cast<std::size_t>(full), '#') +
                     std::string(static_cast<std::size_t>(kBarCells - full), ' ') + "] " +
                     std::to_string(std::lround(100 * now.share)) + " % " + now.what;
  const long passed = std::lround(seconds);
  text += formatted(", %ld:%02ld", passed / 60, passed % 60);
  if (now.share < kEnough) return text;
  const long left = std::lround(seconds * (1 - now.share) / now.share);
  return text + formatted(", about %ld:%02ld left", left / 60, left % 60);
}

}  // namespace saddle
