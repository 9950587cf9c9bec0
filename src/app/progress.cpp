#include "app/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <iostream>

namespace saddle {
namespace {

constexpr int kCells = 30;  // of the bar
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

Progress::Progress(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (shown_) std::cerr << kClearLine << std::flush;
}

void Progress::show(double share, const std::string& what) {
  if (!shown_) return;
  const int full = std::clamp(static_cast<int>(std::lround(share * kCells)), 0, kCells);
  std::cerr << kClearLine << '[' << std::string(static_cast<std::size_t>(full), '#')
            << std::string(static_cast<std::size_t>(kCells - full), ' ') << "] "
            << std::lround(100 * share) << " % " << what << std::flush;
}

}  // namespace saddle
