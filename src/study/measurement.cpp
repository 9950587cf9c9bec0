#include "study/measurement.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "base/error.h"

namespace saddle {
namespace {

/// Repetitions stop when there are as many, and as much time has been spent, as the first pair
/// says, or when one of the second is reached.
constexpr std::size_t kEnough = 9;
constexpr double kEnoughTime = 120;  // milliseconds
constexpr std::size_t kMost = 101;
constexpr double kMostTime = 1000;

/// The share of a panel's time that finding the truth takes, about.
constexpr double kTruthShare = 0.3;

}  // namespace

PanelProgress::PanelProgress(const StudyProgress& progress, std::size_t settings)
    : progress_(progress), settings_(static_cast<double>(settings)) {
  progress_(0, "the truth");
}

void PanelProgress::next(const std::string& method, const std::string& setting) {
  progress_(kTruthShare + (1 - kTruthShare) * begun_++ / settings_, method + ", " + setting);
}

Timing time_repeatedly(const std::function<void()>& work) {
  using Clock = std::chrono::steady_clock;
  std::vector<double> times;
  double total = 0;
  while (times.size() < kMost && total < kMostTime &&
         (times.size() < kEnough || total < kEnoughTime)) {
    const auto begin = Clock::now();
    work();
    times.push_back(std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
    total += times.back();
  }
  if (times.size() > 2) times.erase(times.begin());  // the first finds caches and memory cold
  std::ranges::sort(times);
  const std::size_t last = times.size() - 1;
  return {times[last / 2], times[last / 4], times[last - last / 4]};
}

std::optional<Timing> time_unless_nothing(const std::function<void()>& work) {
  try {
    return time_repeatedly(work);
  } catch (const Error& error) {
    if (error.status() != Status::Nothing) throw;
    return std::nullopt;
  }
}

const char* panel_name(StudyPanel panel) {
  static constexpr std::array kNames = {"evaluation", "normals", "mesh", "image"};
  return kNames[static_cast<std::size_t>(panel)];
}

void mark_pareto(std::vector<Measurement>& measurements) {
  for (Measurement& m : measurements) {
    const auto beats = [&m](const Measurement& other) {
      if (other.panel != m.panel || other.is_limit) return false;
      const bool no_worse = other.time.median <= m.time.median && other.error <= m.error;
      return no_worse && (other.time.median < m.time.median || other.error < m.error);
    };
    m.pareto = !m.is_limit && std::ranges::none_of(measurements, beats);
  }
}

}  // namespace saddle
