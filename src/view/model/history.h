// Undo and redo: scenes as they were before each edit.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/model/scene.h"

namespace saddle {

class History {
 public:
  /// Remembers the scene before an edit. Edits of the same thing in a row, such as letters typed
  /// into one field, are one; an empty `what` is a thing of its own.
  void record(const Scene& before, const std::string& what);

  /// The next edit is one of its own, even if it is of the same thing.
  void end_edit() { last_.clear(); }

  /// The scene before the last edit that is not undone; `now` is kept for redo().
  std::optional<Scene> undo(const Scene& now);
  std::optional<Scene> redo(const Scene& now);

 private:
  std::vector<Scene> past_;
  std::vector<Scene> future_;
  std::string last_;
};

}  // namespace saddle
