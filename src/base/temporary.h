// Names of temporary files, known to the signal handler that removes them.
#pragma once

#include <filesystem>
#include <ostream>
#include <string>

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

/// A file without a name, among the system's temporary ones: it is gone when nothing has it open.
class UnnamedFile {
 public:
  /// Throws Error (Machine) with the system's reason.
  UnnamedFile();
  ~UnnamedFile();
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// The name that a process which inherits the descriptor can open.
  std::string path() const { return "/dev/fd/" + std::to_string(descriptor_); }
  /// All that is in it. Throws Error (Machine) if it cannot be read.
  void copy_to(std::ostream& out) const;

 private:
  int descriptor_ = -1;
};

/// Removes temporaries that are still open when SIGINT, SIGTERM or SIGHUP ends the program, then
/// lets the signal do its default work. Call once, at the start of main.
void remove_temporaries_on_signals();

}  // namespace saddle
