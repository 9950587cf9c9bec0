// The things that the viewer keeps from one start to the next, in the user's state directory: the
// files that were opened last, and work that was not saved.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace saddle {

/// $XDG_STATE_HOME/saddle, or ~/.local/state/saddle; empty: there is neither.
/// Source: freedesktop.org, "XDG Base Directory Specification", 0.8, 2021.
std::filesystem::path state_directory();

/// A directory that cannot be read or written is as good as an empty one, but for work that is
/// lost.
class Session {
 public:
  explicit Session(std::filesystem::path directory = state_directory());

  /// Files that are still there, the last one first.
  std::vector<std::filesystem::path> recent_files() const;
  /// Puts a file before the others.
  void remember_file(const std::filesystem::path& path);

  /// Keeps a scene file's text as this window's unsaved work, in place of the one before. Returns
  /// why it cannot be kept, empty if it is.
  std::string keep_work(const std::string& text);
  /// All is saved: there is none of this window's.
  void forget_work();

  /// The newest work that another window has left when it ended.
  std::optional<std::filesystem::path> left_work() const;

 private:
  std::filesystem::path own_work() const;
  void thin_out() const;

  std::filesystem::path directory_;
  std::string kept_;  ///< the text that is in the file
};

}  // namespace saddle
