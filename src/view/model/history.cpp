#include "view/model/history.h"

#include <utility>

namespace saddle {
namespace {

/// A state takes some kilobytes.
constexpr std::size_t kMostSteps = 1000;

}  // namespace

void History::record(Step before, const std::string& what) {
  ++version_;
  if (!what.empty() && what == last_) return;
  last_ = what;
  future_.clear();
  past_.push_back(std::move(before));
  if (past_.size() > kMostSteps) past_.erase(past_.begin());
}

std::optional<Step> History::exchange(std::vector<Step>& from, std::vector<Step>& to,
                                      const State& now) {
  last_.clear();
  if (from.empty()) return std::nullopt;
  ++version_;
  Step step = std::move(from.back());
  from.pop_back();
  to.push_back({now, step.has_camera});
  return step;
}

std::optional<Step> History::undo(const State& now) {
  return exchange(past_, future_, now);
}

std::optional<Step> History::redo(const State& now) {
  return exchange(future_, past_, now);
}

}  // namespace saddle
