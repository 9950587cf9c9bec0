#include "view/model/history.h"

#include <utility>

namespace saddle {
namespace {

/// A scene takes some kilobytes.
constexpr std::size_t kMostEdits = 1000;

std::optional<Scene> exchange(std::vector<Scene>& from, std::vector<Scene>& to, const Scene& now) {
  if (from.empty()) return std::nullopt;
  to.push_back(now);
  Scene scene = std::move(from.back());
  from.pop_back();
  return scene;
}

}  // namespace

void History::record(const Scene& before, const std::string& what) {
  if (!what.empty() && what == last_) return;
  last_ = what;
  future_.clear();
  past_.push_back(before);
  if (past_.size() > kMostEdits) past_.erase(past_.begin());
}

std::optional<Scene> History::undo(const Scene& now) {
  last_.clear();
  return exchange(past_, future_, now);
}

std::optional<Scene> History::redo(const Scene& now) {
  last_.clear();
  return exchange(future_, past_, now);
}

}  // namespace saddle
