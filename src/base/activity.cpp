#include "base/activity.h"

#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>

namespace saddle {
namespace {

/// Written by the first thread, read by the one that draws the bar: a number may be one step older
/// than another.
struct Level {
  std::atomic<const char*> what = nullptr;
  std::atomic<std::size_t> all = 0;
  std::atomic<std::size_t> done = 0;
  std::atomic<double> share = 0;
  std::atomic<bool> has_detail = false;
};

std::mutex& detail_mutex() {
  static std::mutex mutex;
  return mutex;
}

/// The text of the one level that has it.
std::string& detail() {
  static std::string text;
  return text;
}

/// Frames, surfaces, and stages of a mesh; one more.
std::array<Level, 4> levels;
std::atomic<int> depth = 0;

bool is_first_thread() {
  thread_local const bool is_first = syscall(SYS_gettid) == getpid();
  return is_first;
}

}  // namespace

Activity::Activity(const char* what, std::size_t all) : level_(-1) {
  if (!is_first_thread() || depth == static_cast<int>(levels.size())) return;
  level_ = depth;
  Level& level = levels[static_cast<std::size_t>(level_)];
  level.what = what;
  level.all = all;
  level.done = 0;
  level.share = 0;
  level.has_detail = false;
  depth = level_ + 1;
}

Activity::~Activity() {
  if (level_ >= 0) depth = level_;
}

void Activity::advance() {
  if (level_ < 0) return;
  Level& level = levels[static_cast<std::size_t>(level_)];
  ++level.done;
  level.share = 0;
}

void Activity::set_share(double share) {
  if (level_ >= 0) levels[static_cast<std::size_t>(level_)].share = std::clamp(share, 0.0, 1.0);
}

void Activity::set_detail(const std::string& text) {
  if (level_ < 0) return;
  const std::lock_guard lock(detail_mutex());
  detail() = text;
  levels[static_cast<std::size_t>(level_)].has_detail = true;
}

void tell_share(double share) {
  const int count = depth;
  if (count == 0 || !is_first_thread()) return;
  levels[static_cast<std::size_t>(count) - 1].share = std::clamp(share, 0.0, 1.0);
}

ActivityNow current_activity() {
  ActivityNow now;
  double part = 1;  // of all work, that the level is
  const int count = depth;
  for (int i = 0; i < count; ++i) {
    const Level& level = levels[static_cast<std::size_t>(i)];
    const std::size_t all = level.all;
    const std::size_t done = std::min<std::size_t>(level.done, all);
    const std::string name = level.what.load();
    if (!now.what.empty() && !name.empty()) now.what += ", ";
    now.what += name;
    if (level.has_detail) {
      const std::lock_guard lock(detail_mutex());
      now.what += " " + detail();
    }
    if (all > 1 && !name.empty()) {
      now.what += " " + std::to_string(std::min(done + 1, all)) + " of " + std::to_string(all);
    }
    if (all > 0) {
      now.share += part * static_cast<double>(done) / static_cast<double>(all);
      part /= static_cast<double>(all);
    }
    // Work that is not counted tells its share itself; work within it adds nothing.
    if (all == 0 || i + 1 == count) now.share += part * level.share;
    if (all == 0 && level.share > 0) part = 0;
  }
  now.share = std::clamp(now.share, 0.0, 1.0);
  return now;
}

}  // namespace saddle
