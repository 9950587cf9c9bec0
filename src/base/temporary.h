// Names of temporary files, known to the signal handler that removes them.
#pragma once

#include <filesystem>

namespace saddle {

/// A name for a file that must not outlive this object. While it lives, the handler that
/// remove_temporaries_on_signals() installs removes the file too.
class TemporaryName {
 public:
  /// `.NAME.XXXXXXXX` beside `target`, the X's random. Creates no file.
  explicit TemporaryName(const std::filesystem::path& target);
  /// Removes the file if it is still there.
  ~TemporaryName();
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  int slot_ = -1;  ///< where the handler finds the name; -1: nowhere
};

}  // namespace saddle
