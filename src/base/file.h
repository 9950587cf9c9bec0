// Files that appear whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <span>
#include <string>

namespace saddle {

/// Writes a file through `write`: into a temporary beside `path`, flushed to disk, then renamed
/// over it. If anything fails, or `write` throws, the temporary is removed and `path` is as it was.
/// A file that exists keeps its permissions. "/dev/stdout" and other things that are no regular
/// files are written straight. Links are followed, but for those that another user has put into a
/// folder that others can write to. Throws Error (Machine) that names the path and the system's
/// reason.
void write_file_whole(const std::filesystem::path& path,
                      const std::function<void(std::ostream&)>& write);

struct FileToWrite {
  std::filesystem::path path;
  std::function<void(std::ostream&)> write;
};

/// The same of several files that belong together: none gets its name before all are written. The
/// first file gets its name last.
void write_files_whole(std::span<const FileToWrite> files);

/// A file that is written and has not its name yet: a run may still decide against it.
class StagedFile {
 public:
  /// Writes as write_file_whole() does, with its errors, but renames nothing. A path
  /// that is no regular file gets nothing yet.
  StagedFile(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
  /// Nothing is left of a file that was not published.
  ~StagedFile();
  StagedFile(StagedFile&&) noexcept;
  StagedFile& operator=(StagedFile&&) noexcept;

  /// Gives it its name. Called once. Throws Error (Machine).
  void publish();

 private:
  struct Content;

  std::unique_ptr<Content> content_;
};

/// Lets this process have as many files open as the system allows it, for many StagedFiles.
void allow_many_open_files();

/// The file that a path means once the links at its end are followed; it need not exist. Throws
/// Error (Machine) for links in a circle and for those that are not followed.
std::filesystem::path follow_links(const std::filesystem::path& path);

/// Throws Error (Machine) if a file could not be written there: a missing folder, no permission, a
/// path that is a folder. Called before the computing starts, so that a run fails early.
void check_writable(const std::filesystem::path& path);

/// The whole content of a file, at most 1 GiB. Throws Error (Machine) with the system's reason.
std::string read_file(const std::filesystem::path& path);

/// All that is left of standard input, in the same way.
std::string read_standard_input();

}  // namespace saddle
