// Names of temporary files, known to the signal handler that removes them.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <ostream>
#include <string>

#include "base/descriptor.h"

namespace saddle {

/// A new file that must not outlive this object unless it gets its final name. While it lives, the
/// handler that remove_temporaries_on_signals() installs removes the file too, and its lock tells
/// other runs that it is in use. The first one in a folder removes what killed runs have left
/// there.
class TemporaryFile {
 public:
  /// Creates `.NAME.saddle-XXXXXXXX` beside `target`, the X's random, with the permissions `mode`
  /// less the umask; error() tells whether it has.
  TemporaryFile(const std::filesystem::path& target, mode_t mode);
  /// Removes the file unless it has been renamed.
  ~TemporaryFile();
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  /// errno if there is no file, else 0.
  int error() const { return error_; }
  const Descriptor& file() const { return file_; }
  /// Gives it that name, in the same folder; false with errno if it cannot.
  bool rename_to(const std::filesystem::path& target);

 private:
  std::filesystem::path path_;
  void* entry_;  ///< where the handler finds the name
  Descriptor file_;
  int error_ = 0;
  bool is_kept_ = false;
};

/// A file without a name, among the system's temporary ones: it is gone when nothing has it open.
class UnnamedFile {
 public:
  /// In the folder that TMPDIR names, else /tmp. Throws Error (Machine) with the system's reason.
  UnnamedFile();
  ~UnnamedFile();
  UnnamedFile(const UnnamedFile&) = delete;
  UnnamedFile& operator=(const UnnamedFile&) = delete;

  int descriptor() const { return descriptor_; }
  /// The name that a process which inherits the descriptor can open.
  std::string path() const { return "/dev/fd/" + std::to_string(descriptor_); }
  /// Waits by `finish` for the program `name` that writes to it. Throws Error (Machine) if it has
  /// written nothing or the file system takes no more, as the end may be missing then, and what
  /// `finish` throws; if the file system is full, with a word about that.
  void check_written(const std::string& name, const std::function<void()>& finish) const;
  /// All that is in it. Throws Error (Machine) if it cannot be read.
  void copy_to(std::ostream& out) const;

 private:
  std::string folder_;
  int descriptor_ = -1;
};

/// Removes temporaries that are still open when SIGINT, SIGTERM, SIGHUP, SIGQUIT or SIGXCPU ends
/// the program, then lets the signal do its default work. Call once, at the start of main.
void remove_temporaries_on_signals();

}  // namespace saddle
