#include "view/model/history.h"

#include <utility>

namespace saddle {
namespace {

/// A state takes some kilobytes.
constexpr std::size_t kMostSteps = 1000;

}  // namespace

void History::record(PastState before, const std::string& what) {
  if (before.is_work) ++version_;
  if (!what.empty() && what == last_) return;
  last_ = what;
  if (before.is_work) future_.clear();
  past_.push_back(std::move(before));
  if (past_.size() > kMostSteps) past_.erase(past_.begin());
}

std::optional<PastState> History::exchange(std::vector<PastState>& from, std::vector<PastState>& to,
                                           const State& now) {
  last_.clear();
  if (from.empty()) return std::nullopt;
  PastState step = std::move(from.back());
  from.pop_back();
  if (step.is_work) ++version_;
  to.push_back({now, step.is_work});
  return step;
}

std::optional<PastState> History::undo(const State& now) {
  return exchange(past_, future_, now);
}

std::optional<PastState> History::redo(const State& now) {
  return exchange(future_, past_, now);
}

}  // namespace saddle
