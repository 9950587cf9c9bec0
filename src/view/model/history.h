// Undo and redo: the states before each change.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "view/model/view_state.h"

namespace saddle {

/// A state that a change led away from.
struct PastState {
  State state;
  bool is_work = true;  ///< the change was one of what a scene file is written for
};

class History {
 public:
  /// Remembers the state before a change. Changes of the same thing in a row, such as letters typed
  /// into one field, are one; an empty `what` is a thing of its own. A change that is no work, such
  /// as a look from elsewhere, leaves what can be done again.
  void record(PastState before, const std::string& what);

  /// The next change is one of its own, even if it is of the same thing.
  void end_edit() { last_.clear(); }

  /// The state before the last change that is not undone; `now` is kept for redo().
  std::optional<PastState> undo(const State& now);
  std::optional<PastState> redo(const State& now);

  bool has_past() const { return !past_.empty(); }
  bool has_future() const { return !future_.empty(); }
  /// Another number after each record(), undo() and redo() that changed work.
  std::size_t version() const { return version_; }

 private:
  std::optional<PastState> exchange(std::vector<PastState>& from, std::vector<PastState>& to,
                                    const State& now);

  std::vector<PastState> past_;
  std::vector<PastState> future_;
  std::string last_;
  std::size_t version_ = 0;
};

}  // namespace saddle
