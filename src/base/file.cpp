#include "base/file.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstddef>
#include <optional>
#include <streambuf>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/temporary.h"

namespace saddle {
namespace {

namespace fs = std::filesystem;

/// Longest chain of symbolic links that is followed; the kernel's own limit.
constexpr int kMostLinks = 40;
constexpr std::size_t kBufferBytes = std::size_t{1} << 20;
/// read_file() gives up here: a device such as /dev/zero never ends.
constexpr std::size_t kLargestFile = std::size_t{1} << 30;

std::string reason(int code) {
  return std::generic_category().message(code);
}

[[noreturn]] void fail_write(const fs::path& path, const std::string& why, std::string hint = {}) {
  throw Error(Status::Machine, "cannot write " + path.string() + ": " + why, {}, std::move(hint));
}

/// Collects what a std::ostream writes and hands it to a descriptor in large pieces.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int number) : number_(number), buffer_(kBufferBytes) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }
  /// errno of the first write that failed, 0 if none did.
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    const char* from = pbase();
    while (error_ == 0 && from < pptr()) {
      const ssize_t written = write(number_, from, static_cast<std::size_t>(pptr() - from));
      if (written >= 0) {
        from += written;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0 ? 0 : -1;
  }

 private:
  int number_;
  int error_ = 0;
  std::vector<char> buffer_;
};

using Writer = std::function<void(std::ostream&)>;

/// Runs `write` on the descriptor. `path` is for messages.
void write_through(int number, const fs::path& path, const Writer& write) {
  DescriptorBuffer buffer(number);
  std::ostream out(&buffer);
  try {
    write(out);
  } catch (...) {
    // The system's reason says more than a writer that found its stream broken.
    if (buffer.error() == 0) throw;
  }
  if (buffer.error() == 0) out.flush();
  if (buffer.error() != 0) fail_write(path, reason(buffer.error()));
  if (!out) fail_write(path, "the data could not be produced");
}

/// The number of the open file that names such as /dev/stdout and /dev/fd/3 stand for. Opening
/// the name instead would write from the start of a file that others may have written to.
std::optional<int> inherited_descriptor(const fs::path& path) {
  const std::string text = path.string();
  if (text == "/dev/stdout") return STDOUT_FILENO;
  if (text == "/dev/stderr") return STDERR_FILENO;
  for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
    if (!text.starts_with(folder)) continue;
    int number = -1;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + folder.size(), end, number);
    if (error == std::errc() && stop == end && number >= 0) return number;
  }
  return std::nullopt;
}

fs::path folder_of(const fs::path& file) {
  return file.has_parent_path() ? file.parent_path() : fs::path(".");
}

/// Whether a link may have been put there for us to follow: others can write to its folder, and it
/// belongs to another user than we, root and the folder's owner. Linux refuses such links in
/// /tmp, fs.protected_symlinks, but only where it follows them itself.
bool is_foreign_link(const fs::path& link) {
  struct stat info {};
  struct stat folder {};
  if (lstat(link.c_str(), &info) != 0 || stat(folder_of(link).c_str(), &folder) != 0) return false;
  const bool is_shared = (folder.st_mode & (S_IWGRP | S_IWOTH)) != 0;
  return is_shared && info.st_uid != geteuid() && info.st_uid != 0 && info.st_uid != folder.st_uid;
}

bool allowed(const fs::path& path, int mode) {
  return faccessat(AT_FDCWD, path.c_str(), mode, AT_EACCESS) == 0;
}

/// Throws unless a file could be created in the folder of `file`.
void check_folder(const fs::path& path, const fs::path& file) {
  const fs::path folder = folder_of(file);
  struct stat info {};
  if (stat(folder.c_str(), &info) != 0) {
    const int code = errno;
    const std::string hint = code == ENOENT ? "create its folder: mkdir -p " + folder.string() : "";
    fail_write(path, reason(code), hint);
  }
  if (!S_ISDIR(info.st_mode)) fail_write(path, reason(ENOTDIR));
  if (!allowed(folder, W_OK | X_OK)) {
    const int code = errno;
    fail_write(path, "its folder " + folder.string() + ": " + reason(code));
  }
}

/// The kind, permissions and owner of the file at a path; nothing if there is none.
using Existing = std::optional<struct stat>;

/// Throws unless `file`, which `path` leads to, could be written; returns what is there now.
Existing check_target(const fs::path& path, const fs::path& file) {
  if (file.empty()) fail_write(path, reason(ENOENT));
  if (!file.has_filename()) fail_write(path, reason(EISDIR));  // ends in a slash
  struct stat info {};
  if (stat(file.c_str(), &info) != 0) {
    const int code = errno;
    check_folder(path, file);
    if (code != ENOENT) fail_write(path, reason(code));
    return std::nullopt;
  }
  if (S_ISDIR(info.st_mode)) fail_write(path, reason(EISDIR));
  if (!allowed(file, W_OK)) fail_write(path, reason(errno));
  if (S_ISREG(info.st_mode)) check_folder(path, file);
  return info;
}

void write_straight(const Descriptor& file, const fs::path& path, const Writer& write) {
  if (!file) fail_write(path, reason(errno));
  write_through(file.number(), path, write);
}

/// Owner and permissions of the file that is replaced. The owner only where the system lets us.
void keep_owner_and_mode(const Descriptor& file, const fs::path& path, const struct stat& old) {
  struct stat now {};
  const bool other_owner =
      fstat(file.number(), &now) == 0 && (now.st_uid != old.st_uid || now.st_gid != old.st_gid);
  const bool kept = !other_owner || fchown(file.number(), old.st_uid, old.st_gid) == 0;
  // Without the owner, its set-id bits and the group's rights would go to another user.
  const mode_t mode = old.st_mode & (kept ? 07777u : 0707u);
  if (fchmod(file.number(), mode) != 0) fail_write(path, reason(errno));
}

/// Data reaches the disk before the name does, so that a crash leaves the old file or the new one.
/// The folder is not flushed: losing the new name to a crash keeps the old file whole.
void flush_to_disk(const Descriptor& file, const fs::path& path) {
  // EINVAL, ENOTSUP: file systems that cannot do it.
  if (fsync(file.number()) != 0 && errno != EINVAL && errno != ENOTSUP) {
    fail_write(path, reason(errno));
  }
}

[[noreturn]] void fail_read(const std::string& name, int error) {
  throw Error(Status::Machine, "cannot read " + name + ": " + reason(error));
}

/// All that can be read from a descriptor; messages call it `name`.
std::string read_all(int number, const std::string& name) {
  std::string content;
  std::vector<char> buffer(kBufferBytes);
  while (true) {
    const ssize_t count = read(number, buffer.data(), buffer.size());
    if (count == 0) return content;
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail_read(name, errno);
    content.append(buffer.data(), static_cast<std::size_t>(count));
    if (content.size() > kLargestFile) fail_read(name, EFBIG);
  }
}

}  // namespace

fs::path follow_links(const fs::path& path) {
  fs::path file = path;
  std::error_code none;
  for (int i = 0; i < kMostLinks; ++i) {
    if (!fs::is_symlink(file, none)) return file;
    if (is_foreign_link(file)) {
      fail_write(path, "another user's link in a folder that others can write to",
                 "remove the link, or name a file in a folder of your own");
    }
    const fs::path target = fs::read_symlink(file, none);
    file = target.is_absolute() ? target : file.parent_path() / target;
  }
  fail_write(path, reason(ELOOP));
}

/// Either a temporary file beside the target, or a copy for what cannot be replaced by renaming.
struct StagedFile::Content {
  explicit Content(const fs::path& path) : path(path), target(path) {}

  fs::path path;
  fs::path target;
  std::optional<TemporaryFile> beside = {};
  std::optional<UnnamedFile> copy = {};
};

StagedFile::StagedFile(const fs::path& path, const Writer& write)
    : content_(std::make_unique<Content>(path)) {
  Content& content = *content_;
  std::optional<struct stat> existing;
  const bool is_inherited = inherited_descriptor(path).has_value();
  if (!is_inherited) {
    content.target = follow_links(path);
    existing = check_target(path, content.target);
  }
  if (is_inherited || (existing && !S_ISREG(existing->st_mode))) {
    content.copy.emplace();
    write_through(content.copy->descriptor(), path, write);
    return;
  }
  const TemporaryFile& file = content.beside.emplace(content.target, 0666);
  if (file.error() != 0) fail_write(path, reason(file.error()));
  if (existing) keep_owner_and_mode(file.file(), path, *existing);
  write_through(file.file().number(), path, write);
  flush_to_disk(file.file(), path);
}

StagedFile::StagedFile(StagedFile&&) noexcept = default;
StagedFile& StagedFile::operator=(StagedFile&&) noexcept = default;
StagedFile::~StagedFile() = default;

void StagedFile::publish() {
  if (content_->copy) {
    return write_file_whole(content_->path,
                            [this](std::ostream& out) { content_->copy->copy_to(out); });
  }
  if (!content_->beside->rename_to(content_->target)) fail_write(content_->path, reason(errno));
}

void write_file_whole(const fs::path& path, const Writer& write) {
  if (const std::optional<int> number = inherited_descriptor(path)) {
    return write_straight(Descriptor(fcntl(*number, F_DUPFD_CLOEXEC, 0)), path, write);
  }
  const fs::path target = follow_links(path);
  const Existing existing = check_target(path, target);
  if (existing && !S_ISREG(existing->st_mode)) {
    return write_straight(Descriptor(open(target.c_str(), O_WRONLY | O_CLOEXEC)), path, write);
  }
  StagedFile(path, write).publish();
}

void write_files_whole(std::span<const FileToWrite> files) {
  if (files.size() == 1) return write_file_whole(files[0].path, files[0].write);
  std::vector<StagedFile> staged;
  for (const FileToWrite& file : files) staged.emplace_back(file.path, file.write);
  for (auto file = staged.rbegin(); file != staged.rend(); ++file) file->publish();
}

void allow_many_open_files() {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return;
  limit.rlim_cur = limit.rlim_max;
  setrlimit(RLIMIT_NOFILE, &limit);
}

void check_writable(const fs::path& path) {
  if (const std::optional<int> number = inherited_descriptor(path)) {
    const int flags = fcntl(*number, F_GETFL);
    if (flags < 0) fail_write(path, reason(errno));
    if ((flags & O_ACCMODE) == O_RDONLY) fail_write(path, reason(EBADF));
    return;
  }
  check_target(path, follow_links(path));
}

std::string read_file(const fs::path& path) {
  const Descriptor file(open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file) fail_read(path.string(), errno);
  return read_all(file.number(), path.string());
}

std::string read_standard_input() {
  return read_all(STDIN_FILENO, "standard input");
}

}  // namespace saddle
